#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "compiler/passes.hpp"
#include "compiler/passes/finding.hpp"
#include "compiler/passes/program_codes.hpp"

namespace wale::passes {
namespace {

constexpr std::size_t most_in_a_hook = 4;

/// Looks at a stitch graph with the program that made it, and tells each kind of regret once.
class Regrets {
 public:
  Regrets(const Program& program, const StitchGraph& graph, Diagnostics& say)
      : program_(program), graph_(graph), say_(say) {}

  void tell() {
    tell_idle_instructions();
    tell_stacks();
    tell_unravelling();
    tell_loose_ends();
    tell_loops_left();
  }

 private:
  Span span_at(int instruction) const { return program_.code[static_cast<std::size_t>(instruction)].span; }
  const Loop& loop_at(int loop) const { return graph_.loops[static_cast<std::size_t>(loop)]; }

  void warn(const Finding& found, std::string_view code, std::string message, std::string hint) const {
    tell_once(found, Severity::warning, code, std::move(message), std::move(hint), say_);
  }

  /// Programs drop and transfer empty needles on purpose, to be sure; so this is but a note.
  void tell_idle_instructions() const {
    std::vector<bool> does(program_.code.size(), false);
    for (const Loop& loop : graph_.loops) {
      if (loop.released >= 0) does[static_cast<std::size_t>(loop.released)] = true;
      for (const Move& move : loop.moves) does[static_cast<std::size_t>(move.instruction)] = true;
    }
    Finding idle;
    for (std::size_t i = 0; i < program_.code.size(); ++i) {
      const Instruction& at = program_.code[i];
      if ((at.op == Op::knit || at.op == Op::split) && at.carriers.empty() && !does[i]) idle.add(at.span);
    }
    tell_once(idle, Severity::note, codes::empty_needle, "the needle holds no loop, so nothing happens", "", say_);
  }

  void tell_stacks() const {
    Finding full;
    std::size_t most = 0;
    const auto look = [&](std::size_t loops, const Span& span) {
      if (loops > most_in_a_hook) full.add(span);
      most = std::max(most, loops);
    };
    for (const Loop& loop : graph_.loops) look(loop.through.size(), loop.span);
    for (const HeldLoops& needle : graph_.on_needles) look(needle.loops.size(), loop_at(needle.loops.back()).span);
    warn(full, codes::stack_high, fmt::format("a needle holds {} loops; hooks take {}", most, most_in_a_hook),
         "knit its loops before it takes more");
  }

  /// In the order in which they are dropped.
  std::vector<int> dropped_loops() const {
    std::vector<int> dropped;
    for (int i = 0; i < static_cast<int>(graph_.loops.size()); ++i)
      if (loop_at(i).dropped) dropped.push_back(i);
    std::stable_sort(dropped.begin(), dropped.end(),
                     [this](int a, int b) { return loop_at(a).released < loop_at(b).released; });
    return dropped;
  }

  /// A dropped loop frees the loops that only it held, and so on down.
  void tell_unravelling() const {
    std::vector<int> holds(graph_.loops.size(), 0);  // how many loops are pulled through each
    for (const Loop& loop : graph_.loops)
      for (const int below : loop.through) ++holds[static_cast<std::size_t>(below)];
    Finding drops;
    std::size_t longest = 0;
    std::vector<int> free;
    for (const int i : dropped_loops()) {
      free.assign(1, i);
      for (std::size_t next = 0; next < free.size(); ++next)
        for (const int below : loop_at(free[next]).through)
          if (--holds[static_cast<std::size_t>(below)] == 0 && !loop_at(below).held) free.push_back(below);
      if (free.size() > 1) drops.add(span_at(loop_at(i).released));
      longest = std::max(longest, free.size());
    }
    warn(drops, codes::column_unravels,
         fmt::format("a live loop is dropped, and what hangs on it unravels: {} loops at most", longest),
         "knit through the loop, or bind it off, before it is dropped");
  }

  void tell_loose_ends() const {
    Finding loose;
    for (const YarnPath& yarn : graph_.yarns)
      if (yarn.went_out >= 0 && loop_at(yarn.loops.back()).dropped &&
          loop_at(yarn.loops.back()).released < yarn.went_out)
        loose.add(span_at(yarn.went_out));
    warn(loose, codes::loose_end, "the carrier goes out, but its last loop was dropped before",
         "take the carrier out before the drop");
  }

  void tell_loops_left() const {
    Finding left;
    for (const Loop& loop : graph_.loops)
      if (loop.held) left.add(loop.span);
    if (left.count == 0) return;
    // The hint matters more here than how many more there are.
    say_.warning(
        codes::loops_left, left.first,
        fmt::format("{} left on the needles", left.count == 1 ? "a loop is" : fmt::format("{} loops are", left.count)),
        "bind them off, or drop them if they are waste; here they stay as a live edge");
  }

  const Program& program_;
  const StitchGraph& graph_;
  Diagnostics& say_;
};

}  // namespace

void check_knitting(const Program& program, const StitchGraph& graph, Diagnostics& say) {
  Regrets(program, graph, say).tell();
}

}  // namespace wale::passes
