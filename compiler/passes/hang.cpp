#include "compiler/passes/hang.hpp"

namespace wale {
namespace {

class Hangings {
 public:
  explicit Hangings(const StitchGraph& graph) : graph_(graph) { of_.loops.resize(graph.loops.size()); }

  Arrangement hang() {
    for (int i = 0; i < static_cast<int>(graph_.loops.size()); ++i) put_feet(i);
    for (const HeldLoops& held : graph_.on_needles) put_heads(held.loops);
    for (int i = 0; i < static_cast<int>(graph_.loops.size()); ++i)
      if (at(i).head < 0) put_heads({i});
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

  const StitchGraph& graph_;
  Arrangement of_;
};

}  // namespace

Arrangement hang(const StitchGraph& graph) { return Hangings(graph).hang(); }

}  // namespace wale
