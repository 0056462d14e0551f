#include "compiler/passes/crossing_loops.hpp"

#include <cstdlib>
#include <map>

namespace wale {
namespace {

int order(const Needle& a, const Needle& b, double racking) {
  const double apart = position(b, racking) - position(a, racking);
  return apart > 0 ? 1 : apart < 0 ? -1 : 0;
}

/// +1 if `a` passes before `b` the last time that they change places, -1 if behind it, 0 if they end in the order in
/// which they began.
int passes_in_front(const Loop& a, const Loop& b) {
  std::map<int, double> events;  // racking by instruction
  for (const Loop* loop : {&a, &b})
    for (const Move& move : loop->moves) events[move.instruction] = move.racking;
  const int begin = order(a.needle, b.needle, b.racking);
  int now = begin, front = 0;
  for (const auto& [instruction, racking] : events) {
    const Needle of_a = needle_before(a, instruction), of_b = needle_before(b, instruction);
    const int next = order(of_a, of_b, racking);
    if (next == 0 || next == now) continue;
    front = on_back(of_a) == on_back(of_b) ? front : on_back(of_a) ? -1 : 1;
    now = next;
  }
  return now != begin ? front : 0;
}

}  // namespace

void mark_crossing_loops(const StitchGraph& graph, Arrangement& arrangement) {
  std::map<int, std::vector<int>> moved;  // by course
  const std::vector<int> courses = courses_of(graph);
  for (int i = 0; i < static_cast<int>(graph.loops.size()); ++i) {
    const Loop& loop = graph.loops[static_cast<std::size_t>(i)];
    if (!loop.moves.empty()) moved[courses[static_cast<std::size_t>(i)]].push_back(i);
  }
  for (const auto& [course, loops] : moved)
    for (const int a : loops)
      for (const int b : loops) {
        const Loop &of_a = graph.loops[static_cast<std::size_t>(a)], &of_b = graph.loops[static_cast<std::size_t>(b)];
        if (a == b || std::abs(of_a.needle.index - of_b.needle.index) > 20) continue;
        if (const int front = passes_in_front(of_a, of_b))
          arrangement.loops[static_cast<std::size_t>(a)].passes = front;
      }
}

}  // namespace wale
