#include "sim/solvers/leeway.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/image.hpp"
#include "sim/solvers/clearance.hpp"

namespace wale {
namespace {

constexpr double along_yarn = 0.3;    // of the diameter
constexpr double across_yarns = 0.6;  // of the diameter
constexpr double least_across = 0.1;  // of the diameter: yarns that lie in each other must be able to part
constexpr double share_of_gap = 0.9;  // two yarns that come nearer by this share of their gap do not meet
constexpr double most_shared = 0.01;  // of the weight

}  // namespace

Leeway::Leeway(const Fabric& fabric) : fabric_(fabric), thickness_(thinnest_diameter(fabric)) {}

void Leeway::update(const Points& q, const std::vector<Gap>& gaps) {
  near_.clear();
  turned_.clear();
  ++version_;
  for (const Gap& gap : gaps) {
    // Beads that are near each other may have axes that are nearer.
    const double apart = gap.distance < gap.diameter / 2 ? axis_distance(fabric_, q, gap) : gap.distance;
    near_.push_back({fabric_.first_point(gap.a), fabric_.first_point(gap.b), gap.image,
                     std::clamp(share_of_gap * apart, least_across * thickness_, across_yarns * thickness_),
                     gap.distance < gap.diameter});
    if (!fabric_.cell || !fabric_.cell->may_curl() || gap.image.isZero()) continue;
    near_.back().turned = static_cast<int>(turned_.size());
    const Image image(*fabric_.cell, q.rightCols<2>(), gap.image);
    const Vec3 centre = q.middleCols<4>(near_.back().b).rowwise().mean();
    turned_.push_back({image.turn(), {image.by_period(centre, 0), image.by_period(centre, 1)}});
  }
  share_motion(q);
}

/// A strain of all of a fabric costs by what it moves as much as by what it moves neighbours, about a diameter apart,
/// against each other. Loose yarn has no neighbours to hold it.
void Leeway::share_motion(const Points& q) {
  shared_ = Eigen::VectorXd::Constant(q.cols(), most_shared);
  if (fabric_.cell) return;
  const double points = static_cast<double>(q.cols());
  const double from_middle = (q.colwise() - q.rowwise().mean()).squaredNorm();
  const double shared = std::min(most_shared, thickness_ * thickness_ * points / from_middle);
  for (const Near& near : near_)
    if (near.touches)
      for (const int first : {near.a, near.b}) shared_.segment<4>(first).setConstant(shared);
}

/// How much further the middle of a is from that of b.
Vec3 Leeway::apart(const Near& near, const Points& move) const {
  const auto periods = fabric_.points.cols();
  if (near.turned < 0) {
    Vec3 apart = (move.middleCols<4>(near.a).rowwise().sum() - move.middleCols<4>(near.b).rowwise().sum()) / 4;
    if (!near.image.isZero()) apart -= move.middleCols<2>(periods) * near.image.cast<double>();
    return apart;
  }
  const Turned& image = turned_[static_cast<std::size_t>(near.turned)];
  return move.middleCols<4>(near.a).rowwise().mean() - image.turn * move.middleCols<4>(near.b).rowwise().mean() -
         image.by_period[0] * move.col(periods) - image.by_period[1] * move.col(periods + 1);
}

double Leeway::share(const Points& move) const {
  double most = 0;
#pragma omp parallel reduction(max : most)
  {
#pragma omp for schedule(static) nowait
    for (std::size_t y = 0; y < fabric_.yarns.size(); ++y) {
      const Yarn& yarn = fabric_.yarns[y];
      for (int k = yarn.first_point; k + 1 < yarn.first_point + yarn.points(); ++k)
        most = std::max(most, (move.col(k + 1) - move.col(k)).squaredNorm());
    }
    most /= along_yarn * along_yarn * thickness_ * thickness_;
#pragma omp for schedule(static)
    for (std::size_t p = 0; p < near_.size(); ++p) {
      const Near& near = near_[p];
      most = std::max(most, apart(near, move).squaredNorm() / (near.allowed * near.allowed));
    }
  }
  return std::sqrt(most);
}

double Leeway::mean(const Near& near, const Eigen::VectorXd& weights) const {
  return (weights.segment<4>(near.a).mean() + weights.segment<4>(near.b).mean()) / 2;
}

template <class Add>
void Leeway::each_block(const Eigen::VectorXd& weights, const Add& add) const {
  for (const Yarn& yarn : fabric_.yarns)
    for (int k = yarn.first_point; k + 1 < yarn.first_point + yarn.points(); ++k) {
      const double weight = (weights[k] + weights[k + 1]) / 2;
      add(k, k, weight);
      add(k + 1, k + 1, weight);
      add(k, k + 1, -weight);
    }
  const int periods = static_cast<int>(fabric_.points.cols());
  for (const Near& near : near_) {
    if (!near.touches || near.turned >= 0) continue;
    const double weight = mean(near, weights);
    std::array<std::pair<int, double>, 10> terms;
    for (int k = 0; k < 4; ++k) {
      terms[static_cast<std::size_t>(k)] = {near.a + k, 0.25};
      terms[static_cast<std::size_t>(k + 4)] = {near.b + k, -0.25};
    }
    std::size_t count = 8;
    for (int axis = 0; axis < 2; ++axis)
      if (near.image[axis] != 0) terms[count++] = {periods + axis, -near.image[axis]};
    for (std::size_t m = 0; m < count; ++m)
      for (std::size_t n = m; n < count; ++n) {
        const auto [p, u] = terms[m];
        const auto [q, v] = terms[n];
        add(std::min(p, q), std::max(p, q), (p == q && m != n ? 2 : 1) * weight * u * v);
      }
  }
}

template <class Add>
void Leeway::each_turned_block(const Eigen::VectorXd& weights, const Add& add) const {
  const int periods = static_cast<int>(fabric_.points.cols());
  for (const Near& near : near_) {
    if (!near.touches || near.turned < 0) continue;
    const double weight = mean(near, weights);
    const Turned& image = turned_[static_cast<std::size_t>(near.turned)];
    std::array<std::pair<int, Mat3>, 10> terms;
    for (int k = 0; k < 4; ++k) {
      terms[static_cast<std::size_t>(k)] = {near.a + k, 0.25 * Mat3::Identity()};
      terms[static_cast<std::size_t>(k + 4)] = {near.b + k, -0.25 * image.turn};
    }
    for (int period = 0; period < 2; ++period)
      terms[static_cast<std::size_t>(8 + period)] = {periods + period,
                                                     -image.by_period[static_cast<std::size_t>(period)]};
    for (std::size_t m = 0; m < terms.size(); ++m)
      for (std::size_t n = m; n < terms.size(); ++n) {
        const int p = terms[m].first, q = terms[n].first;
        const Mat3 block = weight * terms[m].second.transpose() * terms[n].second;
        if (p == q && m != n)
          add(p, q, block + block.transpose());
        else if (p <= q)
          add(p, q, block);
        else
          add(q, p, block.transpose());
      }
  }
}

void Leeway::add_to(Stiffness& K, const Eigen::VectorXd& weights) const {
  for (int i = 0; i < K.points(); ++i) K.add(i, i, shared_[i] * weights[i] * Mat3::Identity());
  const std::vector<int>& places = K.places(this, version_, [&](std::vector<int>& slots) {
    std::size_t count = 0;
    each_block(weights, [&](int, int, double) { ++count; });
    slots.reserve(count);
    each_block(weights, [&](int i, int j, double) { slots.push_back(K.slot(i, j)); });
    each_turned_block(weights, [&](int i, int j, const Mat3&) { slots.push_back(K.slot(i, j)); });
  });
  auto place = places.begin();
  each_block(weights, [&](int, int, double factor) { K.add_at(*place++, factor * Mat3::Identity()); });
  each_turned_block(weights, [&](int, int, const Mat3& block) { K.add_at(*place++, block); });
}

}  // namespace wale
