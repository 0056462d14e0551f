#include "sim/effects/beads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wale {
namespace {

/// Of the diameter: wide enough that a list lasts for several solver steps, narrow enough that it stays short.
constexpr double skin_share = 0.4;

/// Points sorted into cubes, for finding all that lie within one cube's width of each other.
class Grid {
 public:
  Grid(const Points& at, double width) : low_(at.rowwise().minCoeff()), width_(width) {
    const Vec3 span = at.rowwise().maxCoeff() - low_;
    // A few far-flung points must not cost memory: widen the cubes until there are not many more of them than points.
    const double most = 8.0 * static_cast<double>(at.cols()) + 64;
    while ((span / width_ + Vec3::Ones()).prod() > most) width_ *= 1.26;
    for (int k = 0; k < 3; ++k) cells_[k] = static_cast<int>(span[k] / width_) + 1;
    start_.assign(static_cast<std::size_t>(cells_.prod()) + 1, 0);
    order_.resize(static_cast<std::size_t>(at.cols()));
    for (int i = 0; i < at.cols(); ++i) ++start_[flat(cell(at.col(i))) + 1];
    for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
    std::vector<int> next(start_.begin(), start_.end() - 1);
    for (int i = 0; i < at.cols(); ++i) order_[static_cast<std::size_t>(next[flat(cell(at.col(i)))]++)] = i;
  }

  template <class Visit>
  void near(const Vec3& where, const Visit& visit) const {
    const Eigen::Vector3i centre = cell(where);
    for (int z = std::max(centre.z() - 1, 0); z <= std::min(centre.z() + 1, cells_.z() - 1); ++z)
      for (int y = std::max(centre.y() - 1, 0); y <= std::min(centre.y() + 1, cells_.y() - 1); ++y)
        for (int x = std::max(centre.x() - 1, 0); x <= std::min(centre.x() + 1, cells_.x() - 1); ++x) {
          const std::size_t c = flat({x, y, z});
          for (int k = start_[c]; k < start_[c + 1]; ++k) visit(order_[static_cast<std::size_t>(k)]);
        }
  }

 private:
  Eigen::Vector3i cell(const Vec3& at) const { return ((at - low_) / width_).cast<int>(); }
  std::size_t flat(const Eigen::Vector3i& c) const {
    return static_cast<std::size_t>(c.x()) +
           static_cast<std::size_t>(cells_.x()) *
               (static_cast<std::size_t>(c.y()) +
                static_cast<std::size_t>(cells_.y()) * static_cast<std::size_t>(c.z()));
  }

  Vec3 low_;
  double width_;
  Eigen::Vector3i cells_;
  std::vector<int> start_, order_;
};

}  // namespace

int beads_per_segment(double rest_length, double diameter, double alpha) {
  return std::max(1, static_cast<int>(std::ceil(rest_length / (diameter * std::sqrt(6 * alpha * (1 + alpha))) - 1e-9)));
}

double inflated_diameter(double diameter, double spacing) {
  return (diameter + std::sqrt(diameter * diameter + 2.0 / 3 * spacing * spacing)) / 2;
}

Beads::Beads(const Fabric& fabric, double alpha, double screening) : fabric_(fabric), screening_(screening) {
  double widest = 0, arc = 0;
  for (int i = 0; i < fabric.segment_count(); ++i) {
    const Segment& segment = fabric.segment(i);
    const double d = fabric.material_of(i).diameter;
    const int n = beads_per_segment(segment.length, d, alpha);
    widest = std::max(widest, d);
    bead_count_.push_back(n);
    first_bead_.push_back(total());
    for (int k = 0; k < n; ++k) {
      arc_.push_back(arc + segment.knitted * (2 * k + 1) / (2 * n));
      segment_of_.push_back(i);
    }
    arc += segment.knitted;
    if (index(n) >= bases_.size()) bases_.resize(index(n) + 1);
    if (bases_[index(n)].empty())
      for (int k = 0; k < n; ++k) bases_[index(n)].push_back(basis((2.0 * k + 1) / (2 * n)));
  }
  skin_ = skin_share * widest;
  reach_ = widest + skin_;
}

void Beads::locate(const Points& q) {
  at_.resize(3, total());
#pragma omp parallel for schedule(static)
  for (int i = 0; i < fabric_.segment_count(); ++i)
    for (int k = 0; k < count(i); ++k)
      at_.col(first_bead_[index(i)] + k) = combine(q, fabric_.first_point(i), basis_of(i, k).value);
}

void Beads::prepare(const Points& q) {
  locate(q);
  if (!at_.allFinite()) return;
  if (listed_at_.cols() != at_.cols() || (at_ - listed_at_).colwise().squaredNorm().maxCoeff() > skin_ * skin_ / 4) {
    find_pairs();
    listed_at_ = at_;
    ++version_;
  }
  distance_.resize(pairs_.size());
  double closest = std::numeric_limits<double>::infinity();
#pragma omp parallel for schedule(static) reduction(min : closest)
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    distance_[p] = distance_between(pairs_[p]);
    closest = std::min(closest, distance_[p] / diameter(pairs_[p].a, pairs_[p].b));
  }
  closest_ = closest;
}

void Beads::find_pairs() {
  const Grid grid(at_, reach_);
  std::vector<std::vector<int>> partners(index(fabric_.segment_count()));
#pragma omp parallel for schedule(dynamic, 64)
  for (int a = 0; a < fabric_.segment_count(); ++a) {
    auto& mine = partners[index(a)];
    for (int k = 0; k < count(a); ++k)
      grid.near(position(a, k), [&](int bead) {
        const int b = segment_of_[index(bead)];
        if (b > a && (mine.empty() || mine.back() != b) && is_within_reach(a, k, bead)) mine.push_back(b);
      });
    std::sort(mine.begin(), mine.end());
    mine.erase(std::unique(mine.begin(), mine.end()), mine.end());
  }
  pairs_.clear();
  for (int a = 0; a < fabric_.segment_count(); ++a)
    for (const int b : partners[index(a)]) pairs_.push_back({a, b});
}

bool Beads::is_within_reach(int a, int bead_a, int other) const {
  const int b = segment_of_[index(other)];
  const double reach = diameter(a, b) + skin_;
  return (position(a, bead_a) - at_.col(other)).squaredNorm() < reach * reach &&
         !screened(a, bead_a, b, other - first_bead_[index(b)]);
}

double Beads::distance_between(const SegmentPair& pair) const {
  double closest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < count(pair.a); ++i)
    for (int j = 0; j < count(pair.b); ++j) {
      const double squared = (position(pair.a, i) - position(pair.b, j)).squaredNorm();
      if (squared < closest && !screened(pair.a, i, pair.b, j)) closest = squared;
    }
  return std::sqrt(closest);
}

}  // namespace wale
