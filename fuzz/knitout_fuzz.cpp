/// Any bytes as a knitout file: read, checked, knitted, cropped, printed, read back, and if it is small drawn.
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

  constexpr std::size_t small = 200;  // loops
  if (knitted.graph.loops.size() > small) return 0;
  const wale::KnitoutOptions options{{}, {7.6e-3, {}}, wale::Plating::first_in_front};
  const auto compiled = wale::compile_knitout(source, options, {}, 8, say);
  if (compiled && !compiled->fabric.points.allFinite()) std::abort();
  return 0;
}
