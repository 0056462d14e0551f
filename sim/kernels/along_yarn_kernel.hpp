/// The kernel that carries a law at a point of the yarn to the control points, `lanes` segments at a time.
/// It uses nothing but its own number type, so that no other translation unit can share what is compiled here.
#pragma once

#include "sim/kernels/along_yarn_block.hpp"
#include "sim/kernels/real.hpp"
#include "sim/kernels/site.hpp"

namespace wale {

template <class Real, class L>
class AlongYarnKernel {
 public:
  static void add(const L& law, AlongBlock& block) { AlongYarnKernel(law, block).run(); }

 private:
  static_assert(lanes<Real> <= block_padding);

  AlongYarnKernel(const L& law, AlongBlock& block) : law_(law), block_(block) {}

  void run() {
    split();
    for (int i = 0; i < block_.count; i += lanes<Real>) add_segments(i);
    (L::elastic ? block_.energy : block_.dissipation) = sum(scalar_);
    if (block_.force) add_forces();
  }

  /// One array a coordinate; what lies beyond the last point repeats it.
  void split() {
    const int points = block_.count + 3;
    for (int p = 0; p < points; ++p)
      for (int c = 0; c < 3; ++c) points_[c][p] = block_.points[3 * p + c];
    for (int p = points; p < points + lanes<Real> - 1; ++p)
      for (int c = 0; c < 3; ++c) points_[c][p] = points_[c][points - 1];
  }

  Vector<Real> combine(int i, const double (&weight)[4]) const {
    Vector<Real> sum;
    Real* const of[] = {&sum.x, &sum.y, &sum.z};
    for (int c = 0; c < 3; ++c) {
      const double* x = points_[c] + i;
      *of[c] = weight[0] * load<Real>(x) + weight[1] * load<Real>(x + 1) + weight[2] * load<Real>(x + 2) +
               weight[3] * load<Real>(x + 3);
    }
    return sum;
  }

  Site<Real> site(int i, int node) const {
    const NodeWeights& of = block_.nodes[node];
    Site<Real> at;
    if constexpr (L::derivative == 0) (L::elastic ? at.y : at.v) = combine(i, of.value);
    if constexpr (L::derivative >= 1) at.dy = combine(i, of.first);
    if constexpr (L::derivative == 2) at.ddy = combine(i, of.second);
    at.l = load<Real>(block_.l + i);
    at.l0 = load<Real>(block_.l0 + i);
    at.constant = load<Real>(block_.constant + i);
    if (block_.reference) {
      const double* from = block_.reference + 3 * node * block_.reference_stride + i;
      at.reference = {load<Real>(from), load<Real>(from + block_.reference_stride),
                      load<Real>(from + 2 * block_.reference_stride)};
    }
    return at;
  }

  void add_segments(int i) {
    Vector<Real> on[4];
    Real scalar = 0;
    for (int node = 0; node < block_.node_count; ++node) {
      const NodeWeights& of = block_.nodes[node];
      Slope<Real> slope;
      law_(site(i, node), slope);
      scalar = scalar + of.weight * (L::elastic ? slope.energy : slope.dissipation);
      for (int k = 0; k < 4; ++k) {
        if constexpr (L::derivative == 0) on[k] += Real(of.weight * of.value[k]) * (L::elastic ? slope.y : slope.v);
        if constexpr (L::derivative >= 1) on[k] += Real(of.weight * of.first[k]) * slope.dy;
        if constexpr (L::derivative == 2) on[k] += Real(of.weight * of.second[k]) * slope.ddy;
      }
    }
    store(scalar, scalar_ + i);
    if (!block_.force) return;
    for (int k = 0; k < 4; ++k) {
      store(on[k].x, slopes_[k][0] + margin + i);
      store(on[k].y, slopes_[k][1] + margin + i);
      store(on[k].z, slopes_[k][2] + margin + i);
    }
  }

  /// In eight sums, so that it is the same for any number of lanes.
  double sum(double* terms) const {
    for (int i = block_.count; i < block_.count + block_padding; ++i) terms[i] = 0;
    double sums[8] = {};
    for (int i = 0; i < block_.count; i += 8)
      for (int j = 0; j < 8; ++j) sums[j] += terms[i + j];
    return ((sums[0] + sums[4]) + (sums[2] + sums[6])) + ((sums[1] + sums[5]) + (sums[3] + sums[7]));
  }

  /// A control point gathers from the four segments that it carries.
  void add_forces() {
    for (auto& of_point : slopes_)
      for (double* of : of_point) {
        for (int i = 1; i <= 3; ++i) of[margin - i] = 0;
        for (int i = 0; i < 3; ++i) of[margin + block_.count + i] = 0;
      }
    const int points = block_.count + 3;
    for (int c = 0; c < 3; ++c)
      for (int p = 0; p < points; p += lanes<Real>) {
        const auto from = [&](int k) { return load<Real>(slopes_[k][c] + margin + p - k); };
        store(Real(((from(0) + from(1)) + from(2)) + from(3)), points_[c] + p);
      }
    for (int p = 0; p < points; ++p)
      for (int c = 0; c < 3; ++c) block_.force[3 * p + c] -= points_[c][p];
  }

  static constexpr int margin = 8;  // before the first segment's slopes
  const L& law_;
  AlongBlock& block_;
  double points_[3][block_length + 2 * block_padding];              // coordinates, then forces
  double slopes_[4][3][margin + block_length + 2 * block_padding];  // on each control point of each segment
  double scalar_[block_length + block_padding];
};

}  // namespace wale
