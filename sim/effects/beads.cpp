#include "sim/effects/beads.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>

#include "sim/effects/grid.hpp"
#include "sim/kernels/kernels.hpp"

namespace wale {
namespace {

// Of a fabric that curls: how much less than the mid-surface yarn may measure on the side of the axis, and how far
// around images may be, as the fabric does not meet itself behind the axis. The next repeat is nearer than that.
constexpr double least_shortening = 0.2, half_turn = std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double much = 0.25;  // of the segments: where more have moved all are listed anew

/// Ranges of segments: enough for many threads, but not so short that most contacts reach out of them.
std::vector<int> even_boundaries(int segments) {
  const int length = std::clamp(segments / 8, 256, 4096), count = std::max(segments / length, 1);
  std::vector<int> boundaries;
  for (int i = 0; i <= count; ++i) boundaries.push_back(static_cast<int>(static_cast<long>(segments) * i / count));
  return boundaries;
}

}  // namespace

int beads_per_segment(double rest_length, double diameter, double alpha) {
  return std::max(1, static_cast<int>(std::ceil(rest_length / (diameter * std::sqrt(6 * alpha * (1 + alpha))) - 1e-9)));
}

double inflated_diameter(double diameter, double spacing) {
  return (diameter + std::sqrt(diameter * diameter + 2.0 / 3 * spacing * spacing)) / 2;
}

Beads::Beads(const Fabric& fabric, double alpha, double screening, double skin)
    : fabric_(fabric), screening_(screening) {
  double widest = 0, arc = 0;
  for (int i = 0; i < fabric.segment_count(); ++i) {
    const Segment& segment = fabric.segment(i);
    const double d = fabric.material_of(i).diameter;
    const int n = beads_per_segment(segment.length, d, alpha);
    widest = std::max(widest, d);
    bead_count_.push_back(n);
    first_bead_.push_back(total());
    for (int k = 0; k < n; ++k) arc_.push_back(arc + segment.knitted * (2 * k + 1) / (2 * n));
    arc += segment.knitted;
    length_of_yarn_.resize(fabric.yarns.size());
    length_of_yarn_[index(segment.yarn)] += segment.knitted;
    if (index(n) >= bases_.size()) bases_.resize(index(n) + 1);
    if (bases_[index(n)].empty())
      for (int k = 0; k < n; ++k) bases_[index(n)].push_back(basis((2.0 * k + 1) / (2 * n)));
  }
  skin_ = skin * widest;
  reach_ = widest + skin_;
  set_up_kernels();
}

void Beads::set_up_kernels() {
  const auto segments = index(fabric_.segment_count()), materials = fabric_.materials.size();
  stride_ = (bases_.size() - 1 + row_step - 1) / row_step * row_step;
  boundaries_ = even_boundaries(fabric_.segment_count());
  rows_.resize(3 * stride_ * segments, 0);
  image_rows_ = {rows_.data()};
  arc_rows_.resize(stride_ * segments);
  weights_.resize(5 * stride_ * bases_.size());
  spread_weights_.resize(4 * stride_ * bases_.size());
  for (std::size_t n = 0; n < bases_.size(); ++n) {
    double* of = weights_.data() + 5 * stride_ * n;
    for (std::size_t j = 0; j < bases_[n].size(); ++j)
      for (std::size_t k = 0; k < 4; ++k) {
        of[k * stride_ + j] = bases_[n][j].value[k];
        spread_weights_[4 * (stride_ * n + j) + k] = bases_[n][j].value[k];
      }
    std::fill(of + 4 * stride_ + bases_[n].size(), of + 5 * stride_, nowhere);
  }
  for (int i = 0; i < fabric_.segment_count(); ++i) {
    first_point_.push_back(fabric_.first_point(i));
    material_.push_back(fabric_.segment(i).material);
    for (int k = 0; k < count(i); ++k) arc_rows_[stride_ * index(i) + index(k)] = arc(i, k);
  }
  for (std::size_t a = 0; a < materials; ++a)
    for (std::size_t b = 0; b < materials; ++b) {
      const double d = (fabric_.materials[a].diameter + fabric_.materials[b].diameter) / 2;
      diameter_.push_back(d);
      screening_length_.push_back(screening_ * d);
    }
  index_pairs();
}

bool Beads::locate(const Points& q) {
  const bool listed = listed_rows_.size() == rows_.size();
  // A bead and the image of another come nearer by what both have moved, and by what the periods have.
  const double may_move = listed ? (skin_ - nearer_by_periods(q)) / 2 : 0;
  const BeadLocating locating{.rows = rows(),
                              .q = q.data(),
                              .first_point = first_point_.data(),
                              .weights = weights_.data(),
                              .before = listed ? listed_rows_.data() : nullptr,
                              .most_moved = may_move > 0 ? may_move * may_move : -1,
                              .at = rows_.data()};
  const bool sleepers_stay = listed && sleepers_located_;
  bool near = listed;
#pragma omp parallel for schedule(static) reduction(&& : near)
  for (std::size_t i = 1; i < boundaries_.size(); ++i)
    near = (sleepers_stay ? locate_awake(locating, boundaries_[i - 1], boundaries_[i])
                          : kernels().beads.locate(locating, boundaries_[i - 1], boundaries_[i])) &&
           near;
  sleepers_located_ = !asleep_.empty();
  return near;
}

bool Beads::locate_awake(const BeadLocating& locating, int first, int last) const {
  bool near = true;
  const auto end = asleep_.begin() + last;
  for (auto begin = std::find(asleep_.begin() + first, end, 0); begin != end;) {
    const auto asleep = std::find(begin, end, 1);
    near &= kernels().beads.locate(locating, static_cast<int>(begin - asleep_.begin()),
                                   static_cast<int>(asleep - asleep_.begin()));
    begin = std::find(asleep, end, 0);
  }
  return near;
}

void Beads::prepare(const Points& q) {
  if (!locate(q)) {
    for (const double x : rows_)
      if (!std::isfinite(x)) return;
    if (fabric_.cell) find_images(q);
    if (!asleep_.empty()) pairs_ = all_pairs_;
    const bool others = find_pairs(list_anew());
    if (!asleep_.empty()) {
      if (others) all_pairs_ = pairs_;
      keep_awake();
    }
    if (others) {
      index_pairs();
      ++version_;
    }
  }
  if (fabric_.cell) place_images(q);
  double closest = std::numeric_limits<double>::infinity();
  for (int image = 0; image < static_cast<int>(images_.size()); ++image) closest = std::min(closest, measure(image));
  closest_ = std::sqrt(closest);
}

void Beads::leave_out(std::vector<std::uint8_t> asleep) {
  if (asleep_.empty()) all_pairs_ = pairs_;
  asleep_ = std::move(asleep);
  sleepers_located_ = false;
  keep_awake();
  if (asleep_.empty()) all_pairs_.clear();
  index_pairs();
  ++version_;
}

void Beads::keep_awake() {
  const auto sleeps = [this](int segment) { return !asleep_.empty() && asleep_[index(segment)]; };
  pairs_.clear();
  std::copy_if(all_pairs_.begin(), all_pairs_.end(), std::back_inserter(pairs_),
               [&](const SegmentPair& pair) { return !sleeps(pair.a) || !sleeps(pair.b); });
  plain_pairs_ = index(static_cast<int>(
      std::count_if(pairs_.begin(), pairs_.end(), [](const SegmentPair& pair) { return pair.image == 0; })));
}

BeadSpreading Beads::spreading() const {
  return {.stride = static_cast<int>(stride_),
          .count = bead_count_.data(),
          .first_point = first_point_.data(),
          .weights = spread_weights_.data()};
}

BeadPairs Beads::kernel_pairs(int image) const {
  return {.rows = rows(),
          .image = image_rows_[index(image)],
          .displacement = displacements_[index(image)].data(),
          .a = segment_a_.data(),
          .b = segment_b_.data(),
          .near_along = near_along_.data(),
          .arc_on = arc_on_.data(),
          .material = material_.data(),
          .materials = static_cast<int>(fabric_.materials.size()),
          .screening_length = screening_length_.data()};
}

/// The least squared distance over the squared diameter.
double Beads::measure(int image) {
  const BeadMeasuring measuring{
      .pairs = kernel_pairs(image), .inverse_square = inverse_square_.data(), .squared = squared_.data()};
  double closest = std::numeric_limits<double>::infinity();
#pragma omp parallel for schedule(static) reduction(min : closest)
  for (std::size_t i = 1; i < boundaries_.size(); ++i)
    closest =
        std::min(closest, kernels().beads.measure(measuring, static_cast<int>(first_pair(image, boundaries_[i - 1])),
                                                  static_cast<int>(first_pair(image, boundaries_[i]))));
  return closest;
}

double Beads::nearer_by_periods(const Points& q) const {
  if (!fabric_.cell) return 0;
  if (curls()) return nearer_by_turns(q);
  const Points periods = q.rightCols<2>() - listed_periods_;
  double furthest = 0;
  for (const Eigen::Vector2i& image : images_) furthest = std::max(furthest, (periods * image.cast<double>()).norm());
  return furthest;
}

/// An image of the beads' box moves no further than its furthest corner.
double Beads::nearer_by_turns(const Points& q) const {
  double furthest = 0;
  for (const Eigen::Vector2i& steps : images_) {
    const Image before(*fabric_.cell, listed_periods_, steps), now(*fabric_.cell, q.rightCols<2>(), steps);
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 at = listed_box_.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
      furthest = std::max(furthest, (now(at) - before(at)).norm());
    }
  }
  return furthest;
}

/// Those that may come within reach; of an image and its opposite, one.
void Beads::find_images(const Points& q) {
  listed_periods_ = q.rightCols<2>();
  const Vec3 course = listed_periods_.col(0), wale = listed_periods_.col(1);
  const Cylinder on = curls() ? cylinder(*fabric_.cell, listed_periods_) : Cylinder{};
  const double middle = curls() ? middle_angle(q.leftCols(q.cols() - 2), on) : 0;
  listed_box_.setEmpty();
  Eigen::AlignedBox3d flat;
  for (int i = 0; i < fabric_.segment_count(); ++i)
    for (int k = 0; k < count(i); ++k) {
      listed_box_.extend(position(i, k));
      flat.extend(rolled_out(position(i, k), on, middle));
    }
  // Towards the axis a way is shorter than along the mid-surface.
  const double nearest = std::max(on.curvature * flat.max().z(), on.curvature * flat.min().z());
  Vec3 longer = Vec3::Ones();
  longer[on.around] = 1 / std::max(least_shortening, 1 - nearest);
  listed_box_.min().array() -= skin_;
  listed_box_.max().array() += skin_;
  const Vec3 span = flat.sizes() + longer * (reach_ + skin_);
  const double once_around = on.curvature == 0 ? infinity : half_turn / std::abs(on.curvature);
  images_.assign(1, Eigen::Vector2i::Zero());
  for (int up = 0; up * std::abs(wale.y()) < span.y(); ++up) {
    const double off = up * wale.x() / course.x(), most = span.x() / std::abs(course.x());
    for (int across = static_cast<int>(std::ceil(-most - off)); across <= most - off; ++across)
      if ((up > 0 || across > 0) && std::abs((across * course + up * wale)[on.around]) < once_around)
        images_.emplace_back(across, up);
  }
  place_images(q);
}

void Beads::place_images(const Points& q) {
  image_rows_.assign(images_.size(), rows_.data());
  if (curls()) {
    displacements_.assign(images_.size(), Vec3::Zero());
    turned_.clear();
    turned_rows_.resize(images_.size());
    for (int image = 0; image < static_cast<int>(images_.size()); ++image) {
      turned_.emplace_back(*fabric_.cell, q.rightCols<2>(), images_[index(image)]);
      if (image > 0) turn_image(image);
    }
    return;
  }
  displacements_.clear();
  for (const Eigen::Vector2i& image : images_) displacements_.emplace_back(q.rightCols<2>() * image.cast<double>());
}

void Beads::turn_image(int image) {
  LargeArray<double>& rows = turned_rows_[index(image)];
  rows = rows_;
  for (int i = 0; i < fabric_.segment_count(); ++i)
    for (int k = 0; k < count(i); ++k) {
      const Vec3 at = turned_[index(image)](position(i, k));
      for (std::size_t axis = 0; axis < 3; ++axis)
        rows[(3 * index(i) + axis) * stride_ + index(k)] = at[static_cast<int>(axis)];
    }
  image_rows_[index(image)] = rows.data();
}

/// Where little has moved, only that: what has gone half as far as it may would soon be too far. What an endless fabric
/// is listed by is of one time.
std::vector<std::uint8_t> Beads::list_anew() {
  const auto segments = index(fabric_.segment_count());
  std::vector<std::uint8_t> anew(segments, 1);
  if (listed_rows_.size() == rows_.size() && !fabric_.cell) {
    const double stays = skin_ / 4;
    long moved = 0;
#pragma omp parallel for schedule(static) reduction(+ : moved)
    for (int i = 0; i < fabric_.segment_count(); ++i) {
      double furthest = 0;
      for (int k = 0; k < count(i); ++k) furthest = std::max(furthest, (position(i, k) - listed(i, k)).squaredNorm());
      anew[index(i)] = furthest > stays * stays;
      moved += anew[index(i)];
    }
    if (static_cast<double>(moved) > much * static_cast<double>(segments)) anew.assign(segments, 1);
  }
  listed_rows_.resize(rows_.size());
  for (int i = 0; i < fabric_.segment_count(); ++i)
    if (anew[index(i)]) std::copy_n(rows_.data() + row(i), 3 * stride_, listed_rows_.data() + row(i));
  return anew;
}

Beads::Spheres Beads::spheres() const {
  Spheres of{Points(3, fabric_.segment_count()), Eigen::VectorXd(fabric_.segment_count())};
#pragma omp parallel for schedule(static)
  for (int i = 0; i < fabric_.segment_count(); ++i) {
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < count(i); ++k) sum += listed(i, k);
    of.centres.col(i) = sum / count(i);
    double furthest = 0;
    for (int k = 0; k < count(i); ++k) furthest = std::max(furthest, (listed(i, k) - of.centres.col(i)).squaredNorm());
    of.radii[i] = std::sqrt(furthest);
  }
  return of;
}

/// Whether the list is another then.
bool Beads::find_pairs(const std::vector<std::uint8_t>& anew) {
  const Spheres around = spheres();
  const Grid grid(around.centres, reach_ + 2 * around.radii.maxCoeff());
  std::vector<SegmentPair> found;
  const auto list = [&](int image) { find_pairs(image, grid, around, anew, found); };
  list(0);
  const bool all = std::find(anew.begin(), anew.end(), 0) == anew.end();
  if (!all) {
    std::sort(found.begin(), found.end());
    std::vector<SegmentPair> kept, merged;
    std::copy_if(pairs_.begin(), pairs_.end(), std::back_inserter(kept),
                 [&](const SegmentPair& pair) { return !anew[index(pair.a)] && !anew[index(pair.b)]; });
    std::merge(kept.begin(), kept.end(), found.begin(), found.end(), std::back_inserter(merged));
    found = std::move(merged);
    if (found == pairs_) return false;
  }
  plain_pairs_ = found.size();
  for (int image = 1; image < static_cast<int>(images_.size()); ++image) list(image);
  pairs_ = std::move(found);
  return true;
}

/// Appends pairs with a segment that is listed anew.
void Beads::find_pairs(int image, const Grid& grid, const Spheres& around, const std::vector<std::uint8_t>& anew,
                       std::vector<SegmentPair>& found) const {
  std::vector<std::vector<int>> partners(index(fabric_.segment_count()));
#pragma omp parallel for schedule(dynamic, 64)
  for (int a = 0; a < fabric_.segment_count(); ++a) {
    if (!anew[index(a)]) continue;
    auto& mine = partners[index(a)];
    const Vec3 centre = back(around.centres.col(a), image);
    grid.near(centre, [&](int b) {
      if (image == 0 && (b == a || (b < a && anew[index(b)]))) return;
      const double furthest = diameter(a, b) + skin_ + around.radii[a] + around.radii[b];
      if ((centre - around.centres.col(b)).squaredNorm() < furthest * furthest && is_within_reach({a, b, image}))
        mine.push_back(b);
    });
    std::sort(mine.begin(), mine.end());
  }
  for (int a = 0; a < fabric_.segment_count(); ++a)
    for (const int b : partners[index(a)])
      found.push_back(image == 0 && b < a ? SegmentPair{b, a, image} : SegmentPair{a, b, image});
}

void Beads::index_pairs() {
  first_pair_.assign(images_.size() * (index(fabric_.segment_count()) + 1), 0);
  segment_a_.clear();
  segment_b_.clear();
  near_along_.clear();
  arc_on_.clear();
  inverse_square_.clear();
  for (const SegmentPair& pair : pairs_) {
    segment_a_.push_back(pair.a);
    segment_b_.push_back(pair.b);
    near_along_.push_back(runs_on(pair) && arc(pair.b, 0) + arc_on(pair) - arc(pair.a, count(pair.a) - 1) <
                                               screening_length(pair.a, pair.b));
    arc_on_.push_back(arc_on(pair));
    inverse_square_.push_back(1 / (diameter(pair.a, pair.b) * diameter(pair.a, pair.b)));
  }
  segment_b_.resize(pairs_.size() + pair_padding);
  squared_.resize(pairs_.size());
  std::size_t p = 0;
  auto first = first_pair_.begin();
  for (int image = 0; image < static_cast<int>(images_.size()); ++image)
    for (int a = 0; a <= fabric_.segment_count(); ++a, ++first) {
      *first = static_cast<std::int32_t>(p);
      while (p < pairs_.size() && pairs_[p].image == image && pairs_[p].a == a) ++p;
    }
  find_reaches();
}

void Beads::find_reaches() {
  furthest_.clear();
  reaches_.clear();
  for (std::size_t i = 1; i < boundaries_.size(); ++i) {
    const int first = boundaries_[i - 1], last = boundaries_[i];
    int furthest = last;
    for (std::size_t p = first_pair(0, first); p < first_pair(0, last); ++p)
      furthest = std::max(furthest, pairs_[p].b + 1);
    furthest_.push_back(furthest);
    reaches_.push_back(std::min(furthest, 2 * last - first));
  }
}

void Beads::list_gaps(std::vector<Gap>& out) const {
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    const auto [a, b, image] = pairs_[p];
    out.push_back({a, b, images_[index(image)], distance(p), diameter(a, b)});
  }
}

bool Beads::is_within_reach(const SegmentPair& pair) const {
  const double reach = diameter(pair.a, pair.b) + skin_;
  for (int i = 0; i < count(pair.a); ++i) {
    const Vec3 at = back(listed(pair.a, i), pair.image);
    for (int j = 0; j < count(pair.b); ++j)
      if ((at - listed(pair.b, j)).squaredNorm() < reach * reach && !screened(pair, i, j)) return true;
  }
  return false;
}

}  // namespace wale
