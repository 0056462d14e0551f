/// The contact beads along all yarns, and which segments are near enough for their beads to touch.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <compare>
#include <cstdint>
#include <vector>

#include "sim/effect.hpp"
#include "sim/image.hpp"
#include "sim/kernels/bead_kernels.hpp"
#include "sim/large_pages.hpp"
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
  friend auto operator<=>(const SegmentPair&, const SegmentPair&) = default;
};

/// Spheres evenly spaced at s = (2i - 1) / (2n) along every segment, and the list of segment pairs in reach of each
/// other. The list holds a skin, so that it stays good until some bead has moved half of it; then what has moved is
/// listed anew. In a periodic fabric beads also touch what lies some periods on.
class Beads {
 public:
  /// `skin` over the largest diameter, more than 0.
  Beads(const Fabric&, double alpha, double screening, double skin);

  /// Renews the list if beads have moved too far since it was made. Measures every pair.
  void prepare(const Points& q);
  /// The next prepare() renews the list however little has moved.
  void forget_list() { listed_rows_.clear(); }

  /// Pairs of which both segments are `asleep` are left out of the list, and not measured. Empty: none is.
  void leave_out(std::vector<std::uint8_t> asleep);

  /// Ascending by image, a, b; each two pieces of yarn of an endless fabric once.
  const std::vector<SegmentPair>& pairs() const { return pairs_; }
  /// How many of pairs() are of segments as they lie, the first ones.
  std::size_t plain_pairs() const { return plain_pairs_; }
  /// Course and wale periods by which an image is displaced; the first by none.
  const std::vector<Eigen::Vector2i>& images() const { return images_; }
  /// How far the b of a pair is displaced at the last prepare(), m; not at all if it is turned().
  const Vec3& displacement(const SegmentPair& pair) const { return displacements_[index(pair.image)]; }
  /// The image that a pair is with, if the fabric curls; else, or if it is with b as it lies, null.
  const Image* turned(const SegmentPair& pair) const { return turned(pair.image); }
  const Image* turned(int image) const { return turned_.empty() || image == 0 ? nullptr : &turned_[index(image)]; }
  /// Grows by one whenever the list is renewed.
  long version() const { return version_; }
  /// Smallest bead distance over contact diameter at the last prepare().
  double closest() const { return closest_; }
  /// The smallest distance between beads of pairs()[pair] at the last prepare(), m.
  double distance(std::size_t pair) const { return std::sqrt(squared_distance(pair)); }
  double squared_distance(std::size_t pair) const { return squared_[pair]; }
  /// Appends pairs() with their distances.
  void list_gaps(std::vector<Gap>& out) const;
  /// Where a bead was at the last prepare(), m.
  Vec3 position(int segment, int bead) const { return position(rows_.data(), segment, bead); }
  /// Where the b of a pair was then, before it is displaced, m.
  Vec3 position_of_image(const SegmentPair& pair, int bead) const {
    return position(image_rows_[index(pair.image)], pair.b, bead);
  }
  /// The same, of all beads.
  BeadRows rows() const { return {static_cast<int>(stride_), rows_.data(), arc_rows_.data(), bead_count_.data()}; }
  /// By segment, indices into Fabric::materials.
  const std::vector<std::int32_t>& materials() const { return material_; }
  /// For the kernel that carries pushes of beads to the control points; what is pushed, and whereto, is left open.
  BeadSpreading spreading() const;
  /// Where the pairs of a segment a with an image begin in pairs(); `segment` may be one behind the last.
  std::size_t first_pair(int image, int segment) const { return index(first_pairs_of(image)[segment]); }

  /// Those with an image, for the kernels.
  BeadPairs kernel_pairs(int image) const;
  /// Of pairs(), at the last prepare(), m².
  const double* squared_distances() const { return squared_.data(); }

  /// The segments in ranges [boundaries()[i], boundaries()[i + 1]), which depend on the fabric alone: what is summed
  /// range by range has the same bits for any number of threads.
  const std::vector<int>& boundaries() const { return boundaries_; }
  /// By range: behind its last segment and those that its segments a are paired with as they lie, but no further on
  /// than as many again.
  const std::vector<int>& reaches() const { return reaches_; }
  /// Whether segments are paired beyond the reach of their range.
  bool leaves(std::size_t range) const { return furthest_[range] > reaches_[range]; }

  int count(int segment) const { return bead_count_[index(segment)]; }
  int total() const { return static_cast<int>(arc_.size()); }
  const Basis& basis_of(int segment, int bead) const { return bases_[index(count(segment))][index(bead)]; }
  /// Beads of one yarn nearer along it than the screening length do not touch (Ding et al. 2023, A.3).
  bool screened(const SegmentPair& pair, int bead_a, int bead_b) const {
    return runs_on(pair) &&
           std::abs(arc(pair.b, bead_b) + arc_on(pair) - arc(pair.a, bead_a)) < screening_length(pair.a, pair.b);
  }
  double screening_length(int a, int b) const { return screening_ * diameter(a, b); }  ///< m
  /// Contact diameter of two segments: the mean of both, m.
  double diameter(int a, int b) const {
    return diameter_[index(material_[index(a)]) * fabric_.materials.size() + index(material_[index(b)])];
  }
  const Fabric& fabric() const { return fabric_; }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  const std::int32_t* first_pairs_of(int image) const {
    return first_pair_.data() + index(image) * (index(fabric_.segment_count()) + 1);
  }
  double arc(int segment, int bead) const { return arc_[index(first_bead_[index(segment)] + bead)]; }
  void set_up_kernels();
  /// Whether the pair, an image of b or not, lies on one yarn.
  bool runs_on(const SegmentPair& pair) const {
    return fabric_.segment(pair.a).yarn == fabric_.segment(pair.b).yarn && images_[index(pair.image)].y() == 0;
  }
  /// How much further along its yarn the image of b is than b, m.
  double arc_on(const SegmentPair& pair) const {
    return images_[index(pair.image)].x() * length_of_yarn_[index(fabric_.segment(pair.b).yarn)];
  }
  /// Fills the rows. False if a bead has moved too far since the list was made, or if a number is not finite.
  bool locate(const Points& q);
  /// The same of those of segments first ... last - 1 that do not sleep.
  bool locate_awake(const BeadLocating&, int first, int last) const;
  /// By how much beads and their images may have come nearer since the list was made because the periods changed, m.
  double nearer_by_periods(const Points& q) const;
  double nearer_by_turns(const Points& q) const;
  double measure(int image);
  Vec3 position(const double* rows, int segment, int bead) const {
    const double* x = rows + row(segment) + bead;
    return {x[0], x[stride_], x[2 * stride_]};
  }
  /// Where a bead was when its segment was listed, m.
  Vec3 listed(int segment, int bead) const { return position(listed_rows_.data(), segment, bead); }
  std::size_t row(int segment) const { return 3 * stride_ * index(segment); }
  bool curls() const { return fabric_.cell && fabric_.cell->may_curl(); }
  void find_images(const Points& q);
  void place_images(const Points& q);
  void turn_image(int image);
  /// Where the place is of which `at` is the image.
  Vec3 back(const Vec3& at, int image) const {
    return turned(image) ? turned(image)->back(at) : Vec3(at - displacements_[index(image)]);
  }
  /// One around the beads of each segment, m.
  struct Spheres {
    Points centres;
    Eigen::VectorXd radii;
  };
  Spheres spheres() const;
  std::vector<std::uint8_t> list_anew();
  bool find_pairs(const std::vector<std::uint8_t>& anew);
  void find_pairs(int image, const Grid& grid, const Spheres& around, const std::vector<std::uint8_t>& anew,
                  std::vector<SegmentPair>& found) const;
  void index_pairs();
  void find_reaches();
  void keep_awake();
  bool is_within_reach(const SegmentPair& pair) const;

  const Fabric& fabric_;
  double screening_;
  double skin_ = 0;   // m
  double reach_ = 0;  // m, largest diameter plus skin
  std::vector<int> bead_count_, first_bead_;
  std::vector<double> arc_;                // bead positions along their yarn, knitted length, m
  std::vector<std::vector<Basis>> bases_;  // by bead count
  std::vector<double> length_of_yarn_;     // knitted, m
  std::vector<Eigen::Vector2i> images_{Eigen::Vector2i::Zero()};
  std::vector<Vec3> displacements_{Vec3::Zero()};  // by image, m
  std::vector<Image> turned_;                      // by image; empty unless the fabric curls
  std::vector<LargeArray<double>> turned_rows_;    // likewise: beads
  std::vector<const double*> image_rows_;          // by image: those, or rows_
  std::vector<SegmentPair> pairs_;
  std::size_t plain_pairs_ = 0;
  std::vector<std::uint8_t> asleep_;  // by segment
  bool sleepers_located_ = false;
  std::vector<SegmentPair> all_pairs_;  // whoever sleeps; empty if nobody does
  Points listed_periods_;               // both, when the list was made; empty if the fabric has none
  Eigen::AlignedBox3d listed_box_;      // around all beads then
  double closest_ = 0;
  long version_ = 0;

  // As the kernels want them; see BeadRows, BeadLocating and BeadPairs.
  std::size_t stride_ = 0;
  std::vector<int> boundaries_;
  std::vector<int> furthest_, reaches_;  // by range, one behind the last segment
  LargeArray<double> rows_, listed_rows_;
  std::vector<double> arc_rows_, weights_, spread_weights_;
  std::vector<std::int32_t> first_point_, material_, segment_a_, segment_b_;
  std::vector<std::int32_t> first_pair_;  // by image and segment, with one behind the last
  std::vector<std::uint8_t> near_along_;
  std::vector<double> arc_on_, inverse_square_, squared_;
  std::vector<double> diameter_, screening_length_;  // by both materials
};

}  // namespace wale
