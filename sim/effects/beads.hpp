/// The contact beads along all yarns, and which segments are near enough for their beads to touch.
#pragma once

#include <vector>

#include "sim/effect.hpp"
#include "sim/parts.hpp"
#include "sim/spline.hpp"

namespace wale {

class Grid;

/// Beads a segment: n = ⌈l / (d √(6α(1+α)))⌉ (Ding et al. 2023, Eq. A.5).
int beads_per_segment(double rest_length, double diameter, double alpha);
/// Bead diameter whose envelope has mean diameter d, for beads D apart: (d + √(d² + ⅔ D²)) / 2 (Eq. A.4).
double inflated_diameter(double diameter, double spacing);

/// Two segments some of whose beads may touch.
struct SegmentPair {
  int a = 0, b = 0;  ///< a < b, unless it is an image of b
  int image = 0;     ///< which of Beads::images() of b
};

/// Spheres evenly spaced at s = (2i - 1) / (2n) along every segment, and the list of segment pairs in reach of each
/// other. The list holds a skin, so that it stays good until some bead has moved half of it. In a periodic fabric beads
/// also touch what lies some periods on.
class Beads {
 public:
  Beads(const Fabric&, double alpha, double screening);

  /// Renews the list if beads have moved too far since it was made. Measures every pair.
  void prepare(const Points& q);

  /// Ascending by image, a, b; each two pieces of yarn of an endless fabric once.
  const std::vector<SegmentPair>& pairs() const { return pairs_; }
  /// How many of pairs() are of segments as they lie, the first ones.
  std::size_t plain_pairs() const { return plain_pairs_; }
  /// Course and wale periods by which an image is displaced; the first by none.
  const std::vector<Eigen::Vector2i>& images() const { return images_; }
  /// How far the b of a pair is displaced at the last prepare(), m.
  const Vec3& displacement(const SegmentPair& pair) const { return displacements_[index(pair.image)]; }
  /// Grows by one whenever the list is renewed.
  long version() const { return version_; }
  /// Smallest bead distance over contact diameter at the last prepare().
  double closest() const { return closest_; }
  /// The smallest distance between beads of pairs()[pair] at the last prepare(), m.
  double distance(std::size_t pair) const { return distance_[pair]; }
  /// Appends pairs() with their distances.
  void list_gaps(std::vector<Gap>& out) const;
  /// Where a bead was at the last prepare(), m.
  auto position(int segment, int bead) const { return at_.col(first_bead_[index(segment)] + bead); }

  int count(int segment) const { return bead_count_[index(segment)]; }
  int total() const { return static_cast<int>(arc_.size()); }
  const Basis& basis_of(int segment, int bead) const { return bases_[index(count(segment))][index(bead)]; }
  /// Beads of one yarn nearer along it than the screening length do not touch (Ding et al. 2023, A.3).
  bool screened(const SegmentPair& pair, int bead_a, int bead_b) const {
    const auto [a, b, image] = pair;
    const Eigen::Vector2i& periods = images_[index(image)];
    if (fabric_.segment(a).yarn != fabric_.segment(b).yarn || periods.y() != 0) return false;
    const double on = periods.x() * length_of_yarn_[index(fabric_.segment(b).yarn)];
    return std::abs(arc(b, bead_b) + on - arc(a, bead_a)) < screening_ * diameter(a, b);
  }
  /// Contact diameter of two segments: the mean of both, m.
  double diameter(int a, int b) const {
    return (fabric_.material_of(a).diameter + fabric_.material_of(b).diameter) / 2;
  }
  const Fabric& fabric() const { return fabric_; }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  double arc(int segment, int bead) const { return arc_[index(first_bead_[index(segment)] + bead)]; }
  void locate(const Points& q);
  void find_images(const Points& q);
  void displace_images(const Points& q);
  void find_pairs();
  void find_pairs(int image, const Grid& grid);
  bool is_listed_still(const Points& q) const;
  bool is_within_reach(int image, int a, int bead_a, int other) const;  // `other` counts over all segments
  double distance_between(const SegmentPair&) const;

  const Fabric& fabric_;
  double screening_;
  double skin_ = 0;   // m
  double reach_ = 0;  // m, largest diameter plus skin
  std::vector<int> bead_count_, first_bead_, segment_of_;
  std::vector<double> arc_;                // bead positions along their yarn, knitted length, m
  std::vector<std::vector<Basis>> bases_;  // by bead count
  std::vector<double> length_of_yarn_;     // knitted, m
  std::vector<Eigen::Vector2i> images_{Eigen::Vector2i::Zero()};
  std::vector<Vec3> displacements_{Vec3::Zero()};  // by image, m
  std::vector<SegmentPair> pairs_;
  std::size_t plain_pairs_ = 0;
  std::vector<double> distance_;  // by pair, m
  Points at_;                     // beads now
  Points listed_at_;              // beads when the list was made
  Points listed_periods_;         // and both periods; empty if the fabric has none
  double closest_ = 0;
  long version_ = 0;
};

}  // namespace wale
