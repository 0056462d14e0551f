/// Any bytes as a knitout file: read, checked, knitted, cropped, printed, and read back.
#include <cstdlib>
#include <string>

#include "compiler/compile.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, std::size_t count) {
  const wale::Source source{"fuzz.k", std::string(reinterpret_cast<const char*>(bytes), count)};
  wale::Diagnostics say;
  const wale::Knitted knitted = wale::knit_knitout(source, {}, say);
  wale::passes::crop(knitted.graph, {wale::IntRange{2, 3}, wale::IntRange{-2, 5}});
  for (const wale::Diagnostic& one : say.all()) print(one);
  if (say.failed()) return 0;

  const wale::Source written{"written.k", print(knitted.program)};
  wale::Diagnostics again;
  const wale::Program read = wale::passes::parse_knitout(written, again);
  if (again.failed() || print(read) != written.text) std::abort();
  return 0;
}
