/// Any bytes as a chart: read, lowered, knitted, and written for a machine.
#include <string>

#include "compiler/passes.hpp"

namespace {

constexpr long most_cells = 10'000;  // beyond which only time is tested

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, std::size_t count) {
  const wale::Source source{"fuzz.yaml", std::string(reinterpret_cast<const char*>(bytes), count)};
  wale::Diagnostics say;
  const auto chart = wale::passes::parse_chart(source, {}, say);
  for (const wale::Diagnostic& one : say.all()) print(one);
  if (!chart || static_cast<long>(chart->wales()) * chart->course_count() > most_cells) return 0;
  wale::passes::machine_program(*chart, *wale::find_target("swg"), say);
  const auto program = wale::passes::lower_chart(*chart, say);
  if (program) wale::passes::knit(*program, say);
  return 0;
}
