#include <algorithm>
#include <vector>

#include "compiler/passes.hpp"

namespace wale::passes {
namespace {

class Cropping {
 public:
  explicit Cropping(const StitchGraph& graph) : graph_(graph), number_(graph.loops.size(), -1) {}

  StitchGraph run(const Crop& crop) {
    cut_.carriers = graph_.carriers;
    cut_.widest = graph_.widest;
    keep_loops(crop);
    keep_needles();
    hold_cut_edge();
    for (const YarnPath& yarn : graph_.yarns) keep_yarn(yarn);
    return std::move(cut_);
  }

 private:
  /// The new number of a loop; -1 if it is cut away.
  int number(int loop) const { return number_[static_cast<std::size_t>(loop)]; }

  std::vector<int> kept(const std::vector<int>& loops) const {
    std::vector<int> numbers;
    for (const int loop : loops)
      if (number(loop) >= 0) numbers.push_back(number(loop));
    return numbers;
  }

  void keep_loops(const Crop& crop) {
    const std::vector<int> courses = courses_of(graph_);
    for (std::size_t i = 0; i < graph_.loops.size(); ++i) {
      const Loop& loop = graph_.loops[i];
      if (crop.courses && !crop.courses->holds(courses[i] + 1)) continue;
      if (crop.needles && !crop.needles->holds(loop.needle.index)) continue;
      number_[i] = static_cast<int>(cut_.loops.size());
      cut_.loops.push_back(loop);
    }
    for (Loop& loop : cut_.loops) loop.through = kept(loop.through);
  }

  void keep_needles() {
    for (const HeldLoops& needle : graph_.on_needles)
      if (std::vector<int> loops = kept(needle.loops); !loops.empty())
        cut_.on_needles.push_back({needle.needle, std::move(loops)});
  }

  /// Loops whose children are all cut away would run: they stay on the needles where those children were knit.
  void hold_cut_edge() {
    std::vector<bool> safe(cut_.loops.size(), false);
    for (const Loop& loop : cut_.loops)
      for (const int below : loop.through) safe[static_cast<std::size_t>(below)] = true;
    for (std::size_t i = 0; i < cut_.loops.size(); ++i)
      if (cut_.loops[i].held) safe[i] = true;
    for (std::size_t i = 0; i < graph_.loops.size(); ++i) {
      if (number_[i] >= 0) continue;
      HeldLoops edge{graph_.loops[i].needle, kept(graph_.loops[i].through)};
      std::erase_if(edge.loops, [&](int loop) { return safe[static_cast<std::size_t>(loop)]; });
      for (const int loop : edge.loops) {
        safe[static_cast<std::size_t>(loop)] = true;
        hold(cut_.loops[static_cast<std::size_t>(loop)], graph_.loops[i]);
      }
      if (!edge.loops.empty()) cut_.on_needles.push_back(std::move(edge));
    }
  }

  static void hold(Loop& loop, const Loop& child) {
    loop.held = true;
    loop.released = -1;
    loop.last_needle = child.needle;
    loop.last_racking = child.racking;
  }

  /// A yarn falls into pieces where loops between two others are cut away.
  void keep_yarn(const YarnPath& yarn) {
    std::size_t miss = 0;
    bool joined = false;  // to the loop before
    for (std::size_t i = 0; i < yarn.loops.size(); ++i) {
      const bool keeps = number(yarn.loops[i]) >= 0;
      if (keeps && !joined) cut_.yarns.push_back({yarn.carrier, {}, {}, i == 0 ? yarn.came_in : -1, -1, {}});
      for (; miss < yarn.misses.size() && yarn.misses[miss].loops_before <= static_cast<int>(i); ++miss)
        if (keeps && (joined || i == 0)) add_miss(yarn.misses[miss]);
      if (keeps) cut_.yarns.back().loops.push_back(number(yarn.loops[i]));
      joined = keeps;
    }
    if (!joined) return;
    for (; miss < yarn.misses.size(); ++miss) add_miss(yarn.misses[miss]);
    cut_.yarns.back().went_out = yarn.went_out;
    cut_.yarns.back().end = yarn.end;
  }

  void add_miss(Miss miss) {
    miss.loops_before = static_cast<int>(cut_.yarns.back().loops.size());
    cut_.yarns.back().misses.push_back(miss);
  }

  const StitchGraph& graph_;
  std::vector<int> number_;  // by loop of `graph_`
  StitchGraph cut_;
};

}  // namespace

StitchGraph crop(const StitchGraph& graph, const Crop& wanted) { return Cropping(graph).run(wanted); }

}  // namespace wale::passes
