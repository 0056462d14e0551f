#include "sim/effects/beads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/effects/grid.hpp"

namespace wale {
namespace {

/// Of the diameter: wide enough that a list lasts for several solver steps, narrow enough that it stays short.
constexpr double skin_share = 0.4;

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
    length_of_yarn_.resize(fabric.yarns.size());
    length_of_yarn_[index(segment.yarn)] += segment.knitted;
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
  if (!is_listed_still(q)) {
    if (fabric_.cell) find_images(q);
    find_pairs();
    listed_at_ = at_;
    ++version_;
  }
  if (fabric_.cell) displace_images(q);
  distance_.resize(pairs_.size());
  double closest = std::numeric_limits<double>::infinity();
#pragma omp parallel for schedule(static) reduction(min : closest)
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    distance_[p] = distance_between(pairs_[p]);
    closest = std::min(closest, distance_[p] / diameter(pairs_[p].a, pairs_[p].b));
  }
  closest_ = closest;
}

bool Beads::is_listed_still(const Points& q) const {
  if (listed_at_.cols() != at_.cols()) return false;
  // A bead and the image of another come nearer by what both have moved, and by what the periods have.
  double moved = 2 * std::sqrt((at_ - listed_at_).colwise().squaredNorm().maxCoeff());
  if (fabric_.cell) {
    const Points periods = q.rightCols<2>() - listed_periods_;
    double furthest = 0;
    for (const Eigen::Vector2i& image : images_) furthest = std::max(furthest, (periods * image.cast<double>()).norm());
    moved += furthest;
  }
  return moved <= skin_;
}

/// Those that may come within reach; of an image and its opposite, one.
void Beads::find_images(const Points& q) {
  listed_periods_ = q.rightCols<2>();
  const Vec3 course = listed_periods_.col(0), wale = listed_periods_.col(1);
  const Vec3 span = at_.rowwise().maxCoeff() - at_.rowwise().minCoeff() + Vec3::Constant(reach_ + skin_);
  images_.assign(1, Eigen::Vector2i::Zero());
  for (int up = 0; up * std::abs(wale.y()) < span.y(); ++up) {
    const double off = up * wale.x() / course.x(), most = span.x() / std::abs(course.x());
    for (int across = static_cast<int>(std::ceil(-most - off)); across <= most - off; ++across)
      if (up > 0 || across > 0) images_.emplace_back(across, up);
  }
  displace_images(q);
}

void Beads::displace_images(const Points& q) {
  displacements_.clear();
  for (const Eigen::Vector2i& image : images_) displacements_.emplace_back(q.rightCols<2>() * image.cast<double>());
}

void Beads::find_pairs() {
  const Grid grid(at_, reach_);
  pairs_.clear();
  for (int image = 0; image < static_cast<int>(images_.size()); ++image) {
    find_pairs(image, grid);
    if (image == 0) plain_pairs_ = pairs_.size();
  }
}

void Beads::find_pairs(int image, const Grid& grid) {
  std::vector<std::vector<int>> partners(index(fabric_.segment_count()));
  const Vec3 displacement = displacements_[index(image)];
#pragma omp parallel for schedule(dynamic, 64)
  for (int a = 0; a < fabric_.segment_count(); ++a) {
    auto& mine = partners[index(a)];
    for (int k = 0; k < count(a); ++k)
      grid.near(position(a, k) - displacement, [&](int bead) {
        const int b = segment_of_[index(bead)];
        if ((b > a || image > 0) && (mine.empty() || mine.back() != b) && is_within_reach(image, a, k, bead))
          mine.push_back(b);
      });
    std::sort(mine.begin(), mine.end());
    mine.erase(std::unique(mine.begin(), mine.end()), mine.end());
  }
  for (int a = 0; a < fabric_.segment_count(); ++a)
    for (const int b : partners[index(a)]) pairs_.push_back({a, b, image});
}

void Beads::list_gaps(std::vector<Gap>& out) const {
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    const auto [a, b, image] = pairs_[p];
    out.push_back({a, b, images_[index(image)], distance_[p], diameter(a, b)});
  }
}

bool Beads::is_within_reach(int image, int a, int bead_a, int other) const {
  const SegmentPair pair{a, segment_of_[index(other)], image};
  const double reach = diameter(a, pair.b) + skin_;
  return (position(a, bead_a) - at_.col(other) - displacement(pair)).squaredNorm() < reach * reach &&
         !screened(pair, bead_a, other - first_bead_[index(pair.b)]);
}

double Beads::distance_between(const SegmentPair& pair) const {
  double closest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < count(pair.a); ++i)
    for (int j = 0; j < count(pair.b); ++j) {
      const double squared = (position(pair.a, i) - position(pair.b, j) - displacement(pair)).squaredNorm();
      if (squared < closest && !screened(pair, i, j)) closest = squared;
    }
  return std::sqrt(closest);
}

}  // namespace wale
