#include "sim/stage.hpp"

#include <algorithm>

#include "sim/spline.hpp"

namespace wale {
namespace {

constexpr const char* grip_labels[] = {"grip.start", "grip.end"};

/// The mean ratio of knitted to laid rest length: by so much a held fabric is let shrink while it is tightened.
double mean_shrinkage(const Fabric& fabric) {
  double laid = 0, knitted = 0;
  for (const Segment& segment : fabric.segments) {
    laid += segment.length;
    knitted += segment.knitted;
  }
  return knitted / laid;
}

}  // namespace

Vec3 centre_of(const Fabric& fabric, const std::vector<int>& segments, const Points& q) {
  Vec3 sum = Vec3::Zero();
  for (const int i : segments) sum += combine(q, fabric.first_point(i), basis(0.5).value);
  return sum / std::max<double>(1, static_cast<double>(segments.size()));
}

StageSetup::StageSetup(const Scene& scene, const Stage& stage, const State& start, double tightened,
                       const Sizes& relaxed)
    : scene_(scene),
      stage_(stage),
      start_(start),
      relaxed_(relaxed),
      tightening_(stage.tighten ? Schedule::ramp(tightened, *stage.tighten, stage.duration) : Schedule(tightened)),
      effects_(stage.effects) {
  if (stage.hold == Hold::ends) hold_ends();
  if (stage.mount) mount_ends(*stage.mount);
  if (stage.pull) pull_ends();
}

void StageSetup::hold_ends() {
  const Points& q = start_.q;
  const double from = tightening_(0), to = tightening_(stage_.duration), share = mean_shrinkage(scene_.fabric);
  const double shrink = (1 + to * (share - 1)) / (1 + from * (share - 1));
  const Vec3 centre = (q.rowwise().minCoeff() + q.rowwise().maxCoeff()) / 2;
  for (std::size_t end = 0; end < 2; ++end) {
    Tether grip;
    grip.label = grip_labels[end];
    grip.segments = scene_.gauge.wale_ends[end];
    grip.stiffness = stage_.grip_stiffness;
    grip.centre = centre;
    grip.scale = {shrink, shrink, 1};
    grip.progress = Schedule::ramp(0, 1, stage_.duration);
    effects_.emplace_back(std::move(grip));
  }
}

const std::array<std::vector<int>, 2>& StageSetup::ends(Along along) const {
  return along == Along::wale ? scene_.gauge.wale_ends : scene_.gauge.course_ends;
}

/// Held sideways the ends keep their shape, and the fabric between them comes to rest at the length where a tensile
/// tester reads no force.
void StageSetup::mount_ends(Along along) {
  for (std::size_t end = 0; end < 2; ++end) {
    Tether grip;
    grip.label = grip_labels[end];
    grip.segments = ends(along)[end];
    grip.stiffness = stage_.grip_stiffness;
    grip.axes = along == Along::wale ? Vec3(1, 0, 1) : Vec3(0, 1, 1);
    effects_.emplace_back(std::move(grip));
  }
}

void StageSetup::pull_ends() {
  const auto& grips = ends(stage_.pull->along);
  const Vec3 apart =
      centre_of(scene_.fabric, grips[1], start_.q) - centre_of(scene_.fabric, grips[0], start_.q);
  const Vec3 along = stage_.pull->along == Along::wale ? Vec3::UnitY() : Vec3::UnitX();
  gauge_length_ = apart.dot(along);
  for (std::size_t end = 0; end < 2; ++end) {
    Tether grip;
    grip.label = grip_labels[end];
    grip.segments = grips[end];
    grip.stiffness = stage_.grip_stiffness;
    grip.move = (end == 0 ? -0.5 : 0.5) * stage_.pull->strain * gauge_length_ * along;
    grip.progress = Schedule::ramp(0, 1, stage_.duration);
    effects_.emplace_back(std::move(grip));
  }
}

std::unique_ptr<World> StageSetup::world() const {
  return std::make_unique<World>(scene_.fabric, effects_, tightening_, start_, scene_.clamps);
}

double StageSetup::strain(double t) const { return stage_.pull->strain * t / stage_.duration; }

std::vector<Quantity> StageSetup::measure(World& world, const State& state) const {
  std::vector<Quantity> row{{"t", "s", state.t}};
  world.prepare(state);
  double grip_load[2] = {0, 0};
  const Vec3 along = stage_.pull && stage_.pull->along == Along::course ? Vec3::UnitX() : Vec3::UnitY();
  for (const auto& effect : world.effects()) {
    double energy = 0;
    Points force = Points::Zero(3, state.q.cols());
    Load load{.energy = &energy, .force = &force};
    effect->add(state, load);
    row.push_back({"energy." + std::string(effect->name()), "J", energy});
    for (int end = 0; end < 2; ++end)
      if (effect->name() == grip_labels[end]) grip_load[end] = force.rowwise().sum().dot(along);
  }
  row.push_back({"energy.kinetic", "J", world.mass().kinetic_energy(state.v)});
  row.push_back({"closest", "1", world.closest()});
  if (!stage_.pull) return row;
  // The machine reads what the fabric pulls on the moving grip; the other grip must read the same at rest.
  const double force = (grip_load[1] - grip_load[0]) / 2;
  const bool wale_wise = stage_.pull->along == Along::wale;
  const double width = wale_wise ? relaxed_.width : relaxed_.length;
  const int columns = wale_wise ? scene_.gauge.wales : scene_.gauge.courses;
  row.push_back({"strain", "1", strain(state.t)});
  row.push_back({"force", "N", force});
  row.push_back({"force_per_wale", "N", force / columns});
  row.push_back({"stress", "Pa", force / (width * scene_.gauge.thickness)});
  row.push_back({"force_imbalance", "N", grip_load[1] + grip_load[0]});
  return row;
}

}  // namespace wale
