#include "compiler/passes/hang.hpp"

#include <algorithm>
#include <map>

namespace wale {
namespace {

class Hangings {
 public:
  explicit Hangings(const StitchGraph& graph) : graph_(graph) { of_.loops.resize(graph.loops.size()); }

  Arrangement hang() {
    for (int i = 0; i < static_cast<int>(graph_.loops.size()); ++i) put_feet(i);
    for (const HeldLoops& held : graph_.on_needles) put_heads(held.loops);
    for (const auto& [instruction, loops] : let_go()) put_heads(loops);
    for (int i = 0; i < static_cast<int>(graph_.loops.size()); ++i) at(i).tucked = is_tucked(i);
    return std::move(of_);
  }

 private:
  const Loop& loop(int i) const { return graph_.loops[static_cast<std::size_t>(i)]; }
  Hanging& at(int i) { return of_.loops[static_cast<std::size_t>(i)]; }

  int new_anchor() {
    of_.anchors.emplace_back();
    return static_cast<int>(of_.anchors.size()) - 1;
  }

  /// Loops that one instruction makes of several yarns lie together.
  void put_feet(int i) {
    const bool plated = i > 0 && loop(i).instruction >= 0 && loop(i - 1).instruction == loop(i).instruction;
    Hanging& own = at(i);
    own.sign = on_back(loop(i).needle) ? -1 : 1;
    own.heading = loop(i).direction == Direction::decreasing ? -1 : 1;
    own.feet = plated ? at(i - 1).feet : new_anchor();
    Anchor& anchor = of_.anchors[static_cast<std::size_t>(own.feet)];
    anchor.feet.push_back(i);
    if (plated) return;
    anchor.heads = loop(i).through;
    for (const int parent : loop(i).through) {
      at(parent).via = at(parent).head;
      at(parent).head = own.feet;
    }
  }

  void put_heads(const std::vector<int>& loops) {
    std::vector<int> free;
    for (const int i : loops)
      if (at(i).head < 0) free.push_back(i);
    if (free.empty()) return;
    const int anchor = new_anchor();
    for (const int i : free) at(i).head = anchor;
    of_.anchors[static_cast<std::size_t>(anchor)].heads = std::move(free);
  }

  /// What nothing was pulled through and no needle holds, by what let go of it; front to back.
  std::map<int, std::vector<int>> let_go() {
    std::map<int, std::vector<int>> loops;
    for (int i = 0; i < static_cast<int>(graph_.loops.size()); ++i) {
      if (at(i).head >= 0) continue;
      std::vector<int>& stack = loops[loop(i).released];
      stack.insert(on_back(loop(i).last_needle) ? stack.begin() : stack.end(), i);
    }
    return loops;
  }

  bool is_tucked(int i) {
    if (!loop(i).through.empty()) return false;
    const std::vector<int>& hook = of_.anchors[static_cast<std::size_t>(at(i).head)].heads;
    return std::any_of(hook.begin(), hook.end(), [&](int other) {
      return other < i && !loop(other).through.empty() &&
             needle_before(loop(other), loop(i).instruction) == loop(i).needle;
    });
  }

  const StitchGraph& graph_;
  Arrangement of_;
};

}  // namespace

Arrangement hang(const StitchGraph& graph) { return Hangings(graph).hang(); }

}  // namespace wale
