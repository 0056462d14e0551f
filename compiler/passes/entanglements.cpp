#include "compiler/passes/entanglements.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "sim/clasps.hpp"
#include "sim/net_crossing.hpp"
#include "sim/polyline.hpp"

namespace wale {
namespace {

constexpr int per_segment = 2;  // points of a polyline

/// A stretch of yarn: a loop, half of one, or the float between two.
struct Strand {
  int first = 0, last = -1;     // segments
  int loop = -1;                // that it is of; -1 for a float
  int before = -1, after = -1;  // loops, its neighbours on the yarn
  Eigen::AlignedBox3d box;
};

class Finding {
 public:
  Finding(const StitchGraph& graph, const Fabric& fabric) : graph_(graph), fabric_(fabric) {
    find_loops();
    for (const YarnPath& yarn : graph_.yarns) cut(yarn);
    sort_loops();
  }

  std::vector<Entanglement> find() {
    std::vector<std::vector<Entanglement>> of_strands(strands_.size());
#pragma omp parallel for schedule(dynamic, 64)
    for (std::size_t i = 0; i < strands_.size(); ++i) of_strands[i] = through(strands_[i]);
    std::vector<Entanglement> all;
    for (const auto& some : of_strands) all.insert(all.end(), some.begin(), some.end());
    std::stable_sort(all.begin(), all.end(),
                     [](const Entanglement& a, const Entanglement& b) { return a.loop < b.loop; });
    return all;
  }

 private:
  const Loop& loop(int i) const { return graph_.loops[static_cast<std::size_t>(i)]; }

  Strand strand(int first, int last, int loop, int before, int after) const {
    Strand made{first, last, loop, before, after, {}};
    const Points line = polyline(fabric_, fabric_.points, first, last, 1);
    for (const auto& point : line.colwise()) made.box.extend(Vec3(point));
    return made;
  }

  void find_loops() {
    loops_.resize(graph_.loops.size());
    for (int i = 0; i < fabric_.segment_count(); ++i) {
      const int stitch = fabric_.segment(i).stitch;
      if (stitch < 0) continue;
      Strand& of = loops_[static_cast<std::size_t>(stitch)];
      if (of.loop < 0) of.first = i;
      of.loop = stitch;
      of.last = i;
    }
  }

  /// Loops into halves; what lies between two loops is a float.
  void cut(const YarnPath& yarn) {
    for (std::size_t k = 0; k < yarn.loops.size(); ++k) {
      const int i = yarn.loops[k], before = k > 0 ? yarn.loops[k - 1] : -1,
                after = k + 1 < yarn.loops.size() ? yarn.loops[k + 1] : -1;
      Strand& whole = loops_[static_cast<std::size_t>(i)];
      whole = strand(whole.first, whole.last, i, before, after);
      const int middle = (whole.first + whole.last + 1) / 2;
      strands_.push_back(strand(whole.first, middle - 1, i, before, after));
      strands_.push_back(strand(middle, whole.last, i, before, after));
      const int end = before < 0 ? whole.first : loops_[static_cast<std::size_t>(before)].last + 1;
      if (end < whole.first) strands_.push_back(strand(end, whole.first - 1, -1, before, i));
    }
  }

  /// By height, so that only few need be looked at.
  void sort_loops() {
    for (const Strand& of : loops_) {
      by_height_.push_back(of.loop);
      tallest_ = std::max(tallest_, of.box.sizes().y());
    }
    std::sort(by_height_.begin(), by_height_.end(), [this](int a, int b) { return low(a) < low(b); });
  }

  double low(int loop) const { return loops_[static_cast<std::size_t>(loop)].box.min().y(); }

  template <class Visit>
  void near(const Strand& of, const Visit& visit) const {
    const auto begin = std::lower_bound(by_height_.begin(), by_height_.end(), of.box.min().y() - tallest_,
                                        [this](int loop, double y) { return low(loop) < y; });
    for (auto at = begin; at != by_height_.end() && low(*at) <= of.box.max().y(); ++at)
      if (loops_[static_cast<std::size_t>(*at)].box.intersects(of.box)) visit(loops_[static_cast<std::size_t>(*at)]);
  }

  bool knitted_with(int a, int b) const {
    const auto holds = [](const std::vector<int>& some, int one) {
      return std::find(some.begin(), some.end(), one) != some.end();
    };
    return holds(loop(a).through, b) || holds(loop(b).through, a);
  }

  bool belongs_to(const Strand& strand, const Strand& loop) const {
    if (loop.loop == strand.loop || loop.loop == strand.before || loop.loop == strand.after) return true;
    return strand.loop >= 0 && knitted_with(strand.loop, loop.loop);
  }

  Points line(const Strand& of, int fineness = per_segment) const {
    return polyline(fabric_, fabric_.points, of.first, of.last, fineness);
  }

  std::vector<Entanglement> through(const Strand& strand) const {
    std::vector<Entanglement> found;
    const Points here = line(strand);
    near(strand, [&](const Strand& other) {
      if (belongs_to(strand, other)) return;
      if (std::abs(net_crossing(here, line(other), Vec3::UnitZ())) < 2) return;
      if (std::abs(mean_net_crossing(line(strand, 2 * per_segment), line(other, 2 * per_segment))) < surely_clasped)
        return;
      const int own = strand.loop >= 0 ? strand.loop : strand.after;
      found.push_back({std::max(own, other.loop), std::min(own, other.loop)});
    });
    return found;
  }

  const StitchGraph& graph_;
  const Fabric& fabric_;
  std::vector<Strand> loops_;    // by loop
  std::vector<Strand> strands_;  // halves and floats
  std::vector<int> by_height_;   // loops
  double tallest_ = 0;
};

}  // namespace

std::vector<Entanglement> entanglements(const StitchGraph& graph, const Fabric& fabric) {
  return Finding(graph, fabric).find();
}

}  // namespace wale
