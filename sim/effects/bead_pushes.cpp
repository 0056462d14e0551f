#include "sim/effects/bead_pushes.hpp"

#include <algorithm>

#include "sim/kernels/kernels.hpp"

namespace wale {
namespace {

/// What all contacts are pushed with.
struct Pushing {
  const Beads& beads;
  const double* spacing;
  const double* inverse_square;
};

/// What one range after another is worked out in.
struct Workspace {
  std::vector<double> push, outgoing;  // rows of beads
  std::vector<std::int32_t> touching;
};

/// The contacts of one range of segments: first ... last - 1, whose partners lie before `reach` or are among the few
/// that are kept one by one.
class RangeOfSegments {
 public:
  /// Their energy.
  double push(const Pushing& by, std::size_t range, Workspace& work) {
    const Beads& beads = by.beads;
    first_ = beads.boundaries()[range];
    last_ = beads.boundaries()[range + 1];
    reach_ = beads.reaches()[range];
    idle_ = !has_pairs(beads);
    if (idle_) return 0;
    work.push.assign(row(beads) * static_cast<std::size_t>(reach_ - first_), 0);
    double energy = 0;
    for (int image = 0; image < static_cast<int>(beads.images().size()); ++image)
      energy += push(by, image, image > 0 || beads.leaves(range), work);
    return energy;
  }

  /// Adds to the control points that no other range adds to. All others are kept for later.
  void spread(const Beads& beads, const Workspace& work, Points& force) {
    if (idle_) return;
    const Fabric& fabric = beads.fabric();
    origin_ = fabric.first_point(first_);
    stride_ = fabric.first_point(reach_ - 1) + 4 - origin_;
    own_ = fabric.first_point(last_ - 1) + 4 - origin_;
    force_.resize(3 * static_cast<std::size_t>(stride_));
    BeadSpreading spreading = beads.spreading();
    spreading.push = work.push.data();
    spreading.origin = origin_;
    spreading.force_stride = stride_;
    spreading.force = force_.data();
    kernels().beads.spread(spreading, first_, reach_);
    add(shared_points, own_, force);
    spread_outgoing(beads, work, spreading);
  }

  /// Adds what was kept.
  void add_rest(const Beads& beads, const Points& q, Points& force) const {
    if (idle_) return;
    add(0, shared_points, force);
    add(own_, stride_, force);
    for (std::size_t i = 0; i < outgoing_.size(); ++i)
      add_outgoing(beads.pairs()[static_cast<std::size_t>(outgoing_pairs_[i])], outgoing_[i].transpose(), beads, q,
                   force);
  }

 private:
  static constexpr int shared_points = 3;  // with the segment before
  static std::size_t row(const Beads& beads) { return 3 * static_cast<std::size_t>(beads.rows().stride); }

  bool has_pairs(const Beads& beads) const {
    for (int image = 0; image < static_cast<int>(beads.images().size()); ++image)
      if (beads.first_pair(image, first_) < beads.first_pair(image, last_)) return true;
    return false;
  }

  /// The contacts with one image, of which some may leave the range.
  double push(const Pushing& by, int image, bool leave, Workspace& work) {
    const Beads& beads = by.beads;
    const std::size_t first = beads.first_pair(image, first_), last = beads.first_pair(image, last_);
    const std::size_t before = outgoing_pairs_.size(), most = before + (leave ? last - first : 0);
    work.touching.resize(std::max(work.touching.size(), 2 * (last - first)));
    work.outgoing.resize(std::max(work.outgoing.size(), row(beads) * most));
    outgoing_pairs_.resize(most);
    const BeadPushed pushed = kernels().beads.push({.pairs = beads.kernel_pairs(image),
                                                    .squared = beads.squared_distances(),
                                                    .inverse_square = by.inverse_square,
                                                    .spacing = by.spacing,
                                                    .materials = beads.fabric().materials.data(),
                                                    .first = first_,
                                                    .reach = image > 0 ? 0 : reach_,
                                                    .push = work.push.data(),
                                                    .touching = work.touching.data(),
                                                    .outgoing = work.outgoing.data() + row(beads) * before,
                                                    .outgoing_pair = outgoing_pairs_.data() + before},
                                                   static_cast<int>(first), static_cast<int>(last));
    outgoing_pairs_.resize(before + static_cast<std::size_t>(pushed.outgoing));
    return pushed.energy;
  }

  void spread_outgoing(const Beads& beads, const Workspace& work, BeadSpreading spreading) {
    outgoing_.resize(outgoing_pairs_.size());
    spreading.push = work.outgoing.data();
    spreading.force_stride = 4;
    for (std::size_t i = 0; i < outgoing_.size(); ++i) {
      const int b = beads.pairs()[static_cast<std::size_t>(outgoing_pairs_[i])].b;
      spreading.origin = beads.fabric().first_point(b);
      spreading.force = outgoing_[i].data();
      kernels().beads.spread(spreading, b, b + 1);
      spreading.push += 3 * spreading.stride;
    }
  }

  void add(int from, int to, Points& force) const {
    const double *x = force_.data(), *y = x + stride_, *z = y + stride_;
    for (int p = from; p < to; ++p) force.col(origin_ + p) += Vec3(x[p], y[p], z[p]);
  }

  static void add_outgoing(const SegmentPair& pair, const Eigen::Matrix<double, 3, 4>& on_b, const Beads& beads,
                           const Points& q, Points& force) {
    const int first = beads.fabric().first_point(pair.b);
    if (const Image* turned = beads.turned(pair)) {
      const OnImage back = carried_back(*turned, q.middleCols<4>(first), on_b);
      force.middleCols<4>(first) += back.points;
      force.rightCols<2>() += back.periods;
      return;
    }
    force.middleCols<4>(first) += on_b;
    // An image moves with the periods: together they bear what its control points do.
    if (pair.image > 0)
      force.rightCols<2>() +=
          on_b.rowwise().sum() * beads.images()[static_cast<std::size_t>(pair.image)].cast<double>().transpose();
  }

  int first_ = 0, last_ = 0, reach_ = 0;
  bool idle_ = true;                       // as when all its segments sleep
  int origin_ = 0, own_ = 0, stride_ = 0;  // control points
  std::vector<double> force_;              // on them: all x, then all y, then all z, N
  std::vector<std::int32_t> outgoing_pairs_;
  std::vector<Eigen::Matrix<double, 4, 3>> outgoing_;  // on the four control points of each such b, N
};

}  // namespace

void add_pushes(const Beads& beads, const Points& q, const std::vector<double>& spacing,
                const std::vector<double>& inverse_square, Load& out) {
  const Pushing by{beads, spacing.data(), inverse_square.data()};
  std::vector<RangeOfSegments> ranges(beads.boundaries().size() - 1);
  std::vector<double> energies(ranges.size());
#pragma omp parallel
  {
    Workspace work;
#pragma omp for schedule(static)
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      energies[i] = ranges[i].push(by, i, work);
      if (out.force) ranges[i].spread(beads, work, *out.force);
    }
  }
  if (out.energy)
    for (const double energy : energies) *out.energy += energy;
  if (out.force)
    for (const RangeOfSegments& range : ranges) range.add_rest(beads, q, *out.force);
}

}  // namespace wale
