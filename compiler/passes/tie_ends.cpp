#include "compiler/passes.hpp"

namespace wale::passes {

StitchGraph tie_ends(const StitchGraph& graph) {
  StitchGraph tied = graph;
  tied.yarns.clear();
  if (graph.yarns.empty()) return tied;
  YarnPath yarn = graph.yarns.front();
  yarn.loops.clear();
  for (int i = 0; i < static_cast<int>(graph.loops.size()); ++i) yarn.loops.push_back(i);
  yarn.went_out = graph.yarns.back().went_out;
  yarn.end = graph.yarns.back().end;
  tied.yarns.push_back(std::move(yarn));
  return tied;
}

}  // namespace wale::passes
