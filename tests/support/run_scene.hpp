/// Runs a scene given as text, as if it were a file in patterns/.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "compiler/compile.hpp"
#include "sim/run.hpp"

namespace wale {

/// Throws std::runtime_error if it does not come to its end.
inline Results run_scene(const std::string& text, const RunOptions& options = {}) {
  Sources sources;
  Diagnostics say;
  const Source* source = sources.add(WALE_SOURCE_DIR "/patterns/of_a_test.scene.yaml", text);
  Results results;
  results.scene = compile_scene(*source, sources, say).value();
  if (run(results, options) != Outcome::finished) throw std::runtime_error(results.effort.failure);
  return results;
}

/// The last `count` numbers of a column.
inline std::vector<double> last(const Results& results, const char* name, int count) {
  const std::vector<double>& all = results.samples.find(name)->values;
  return {all.end() - count, all.end()};
}

}  // namespace wale
