#include "sim/stage.hpp"

#include <algorithm>

#include "sim/deform.hpp"
#include "sim/spline.hpp"

namespace wale {
namespace {

constexpr const char* grip_labels[] = {"grip.start", "grip.end"};

/// Of all yarn, m.
double length_of(const Fabric& fabric, const RestLengths& rest) {
  double sum = 0;
  for (const Segment& segment : fabric.segments) sum += rest.of(segment);
  return sum;
}

/// What the fabric presses on an obstacle.
void measure_obstacle(const Effect& obstacle, const Vec3& force, std::vector<Quantity>& row) {
  const std::string name = "force." + std::string(obstacle.name());
  const char* const axes[] = {".x", ".y", ".z"};
  for (int axis = 0; axis < 3; ++axis) row.push_back({name + axes[axis], "N", force[axis]});
}

Vec3 unit(Along along) { return along == Along::wale ? Vec3::UnitY() : Vec3::UnitX(); }

}  // namespace

Vec3 centre_of(const Fabric& fabric, const std::vector<int>& segments, const Points& q) {
  Vec3 sum = Vec3::Zero();
  for (const int i : segments) sum += combine(q, fabric.first_point(i), basis(0.5).value);
  return sum / std::max<double>(1, static_cast<double>(segments.size()));
}

StageSetup::StageSetup(const Scene& scene, const Stage& stage, const State& start, const RestLengths& rest,
                       const Sizes& relaxed, const std::vector<double>& travels)
    : scene_(scene),
      stage_(stage),
      start_(start),
      relaxed_(relaxed),
      rest_(rest_schedules(stage, rest, scene.fabric.materials.size())),
      effects_(stage.effects) {
  if (scene.fabric.cell) {
    guide_periods();
    return;
  }
  if (stage.hold == Hold::ends) hold_ends();
  if (stage.mount) mount_ends(travels);
  if (stage.pull) pull_ends();
}

void StageSetup::guide_periods() {
  const Deform deform = deform_of(stage_);
  const auto part = [&](const Deform::Part& of, double length, double from) {
    PeriodGuide::Part led;
    led.how = static_cast<PeriodGuide::How>(of.how);
    if (of.how != Deform::How::driven) return led;
    std::vector<Schedule::Knot> knots;
    const Schedule strain = strain_of(deform, of, stage_.duration);
    for (const Schedule::Knot& knot : strain.knots()) knots.push_back({knot.t, from + knot.value * length});
    led.length = Schedule(std::move(knots));
    return led;
  };
  const Periods periods = start_.q.rightCols<2>();
  guide_.course = part(deform.course, periods(0, 0), periods(0, 0));
  guide_.wale = part(deform.wale, periods(1, 1), periods(1, 1));
  guide_.lean = part(deform.shear, periods(1, 1), periods(0, 1));
  if (scene_.fabric.cell->may_curl()) {
    guide_.curl = part(deform.curl, 1, 0);
    std::vector<Schedule::Knot> knots = guide_.curl.length.knots();
    knots.front().value = curvature(*scene_.fabric.cell, periods);
    guide_.curl.length = Schedule(std::move(knots));
  }
  gauge_length_ = stage_.pull && stage_.pull->along == Along::course ? periods(0, 0) : periods(1, 1);
}

/// By as much as the yarn becomes shorter the held ends come nearer, and each end becomes narrower.
void StageSetup::hold_ends() {
  const Points& q = start_.q;
  const double shrink = length_of(scene_.fabric, rest_(stage_.duration)) / length_of(scene_.fabric, rest_(0));
  const Vec3 centre = (q.rowwise().minCoeff() + q.rowwise().maxCoeff()) / 2;
  for (std::size_t end = 0; end < 2; ++end) {
    Tether grip = grip_on(Along::wale, end);
    grip.centre = centre;
    grip.scale = {shrink, shrink, 1};
    grip.progress = Schedule::ramp(0, 1, stage_.duration);
    effects_.emplace_back(std::move(grip));
  }
}

const std::array<std::vector<int>, 2>& StageSetup::ends(Along along) const {
  return along == Along::wale ? scene_.gauge.wale_ends : scene_.gauge.course_ends;
}

Tether StageSetup::grip_on(Along along, std::size_t end) const {
  Tether grip;
  grip.label = grip_labels[end];
  grip.segments = ends(along)[end];
  grip.stiffness = stage_.grip_stiffness;
  return grip;
}

void StageSetup::close_grips(Along along) {
  const auto& grips = ends(along);
  const Vec3 apart = centre_of(scene_.fabric, grips[1], start_.q) - centre_of(scene_.fabric, grips[0], start_.q);
  gauge_length_ = apart.dot(unit(along));
}

void StageSetup::move_grips(Along along, Schedule travel) {
  for (std::size_t end = 0; end < 2; ++end) {
    Tether grip = grip_on(along, end);
    grip.move = (end == 0 ? -0.5 : 0.5) * unit(along);
    grip.progress = travel;
    effects_.emplace_back(std::move(grip));
  }
  travel_ = std::move(travel);
}

void StageSetup::mount_ends(const std::vector<double>& travels) {
  std::vector<Schedule::Knot> knots;
  for (std::size_t sample = 0; sample < travels.size(); ++sample)
    knots.push_back({stage_.duration * static_cast<double>(sample) / stage_.samples, travels[sample]});
  close_grips(*stage_.mount);
  move_grips(*stage_.mount, Schedule(std::move(knots)));
}

void StageSetup::pull_ends() {
  close_grips(stage_.pull->along);
  move_grips(stage_.pull->along, strain_of(*stage_.pull, stage_.duration).times(gauge_length_));
}

std::unique_ptr<World> StageSetup::world() const { return world(!std::holds_alternative<RungeKutta>(stage_.solver)); }

std::unique_ptr<World> StageSetup::world(bool lagged) const {
  auto world = std::make_unique<World>(scene_.fabric, effects_, rest_, start_, scene_.clamps, lagged);
  world->guide(guide_);
  return world;
}

std::vector<Quantity> StageSetup::measure(World& world, const State& state) const {
  std::vector<Quantity> row{{"t", "s", state.t}};
  world.prepare(state);
  double grip_load[2] = {0, 0};
  Points total = Points::Zero(3, state.q.cols());
  const Vec3 along = unit(gripped().value_or(Along::wale));
  for (const auto& effect : world.effects()) {
    double energy = 0;
    Points force = Points::Zero(3, state.q.cols());
    Load load{.energy = &energy, .force = &force};
    effect->add(state, load);
    total += force;
    if (!effect->dissipative()) row.push_back({"energy." + std::string(effect->name()), "J", energy});
    if (effect->name().starts_with("obstacle")) measure_obstacle(*effect, Vec3::Zero() - force.rowwise().sum(), row);
    for (int end = 0; end < 2; ++end)
      if (effect->name() == grip_labels[end]) grip_load[end] = force.rowwise().sum().dot(along);
  }
  row.push_back({"energy.kinetic", "J", world.kinetic_energy(state)});
  row.push_back({"closest", "1", world.closest()});
  if (scene_.fabric.cell && stage_.follows_motion())
    measure_periods(force_on_flow(total, state, world.mass()), state, row);
  else if (scene_.fabric.cell)
    measure_periods(world.beside_mid_surface(world.ties().gather(total)).rightCols<2>(), state, row);
  else if (gripped())
    measure_grips(grip_load, state.t, row);
  return row;
}

std::optional<Along> StageSetup::gripped() const {
  return stage_.pull ? std::optional(stage_.pull->along) : stage_.mount;
}

/// What the endless fabric bears across its periods, from the force conjugate to each: a stress is that force over the
/// other period, as it was in the relaxed fabric, and the thickness.
void StageSetup::measure_periods(const Eigen::Matrix<double, 3, 2>& on_periods, const State& state,
                                 std::vector<Quantity>& row) const {
  const Periods periods = state.q.rightCols<2>();
  const double across = relaxed_.width * scene_.gauge.thickness, up = relaxed_.length * scene_.gauge.thickness;
  row.push_back({"period.course", "m", periods(0, 0)});
  row.push_back({"period.wale", "m", periods(1, 1)});
  row.push_back({"period.lean", "m", periods(0, 1)});
  const bool is_known = across > 0 && up > 0;
  if (is_known) {
    row.push_back({"stress.course", "Pa", -on_periods(0, 0) / up});
    row.push_back({"stress.wale", "Pa", -on_periods(1, 1) / across});
    row.push_back({"stress.shear", "Pa", -on_periods(0, 1) / across});
  }
  if (scene_.fabric.cell->may_curl()) measure_curl(on_periods(2, 1), periods, row);
  if (!stage_.strains() || (stage_.deform && stage_.deform->leaves_periods_free())) return;
  const auto before = start_.q.rightCols<2>();
  row.push_back({"strain.course", "1", periods(0, 0) / before(0, 0) - 1});
  row.push_back({"strain.wale", "1", periods(1, 1) / before(1, 1) - 1});
  row.push_back({"strain.shear", "1", (periods(0, 1) - before(0, 1)) / before(1, 1)});
  if (!stage_.pull) return;
  const bool wale_wise = stage_.pull->along == Along::wale;
  const double pulled = wale_wise ? periods(1, 1) : periods(0, 0),
               load = wale_wise ? -on_periods(1, 1) : -on_periods(0, 0);
  row.push_back({"strain", "1", pulled / gauge_length_ - 1});
  row.push_back({"force", "N", load});
  row.push_back({"force_per_wale", "N", load / (wale_wise ? scene_.gauge.wales : scene_.gauge.courses)});
  row.push_back({"stress", "Pa", load / (wale_wise ? across : up)});
}

/// The moment is that about the axis on a length of fabric along it, from the force conjugate to the curvature.
void StageSetup::measure_curl(double force, const Periods& periods, std::vector<Quantity>& row) const {
  const PeriodicCell& cell = *scene_.fabric.cell;
  row.push_back({"curvature", "1/m", curvature(cell, periods)});
  row.push_back({"moment", "N", -force * curl_unit(cell) / (periods(0, 0) * periods(1, 1))});
}

void StageSetup::measure_grips(const double (&grip_load)[2], double t, std::vector<Quantity>& row) const {
  // The machine reads what the fabric pulls on the moving grip; the other grip must read the same at rest.
  const double force = (grip_load[1] - grip_load[0]) / 2;
  const bool wale_wise = gripped() == Along::wale;
  const double width = wale_wise ? relaxed_.width : relaxed_.length;
  const int columns = wale_wise ? scene_.gauge.wales : scene_.gauge.courses;
  if (stage_.mount) row.push_back({"travel", "m", travel_(t)});
  if (stage_.pull) row.push_back({"strain", "1", travel_(t) / gauge_length_});
  row.push_back({"force", "N", force});
  row.push_back({"force_per_wale", "N", force / columns});
  row.push_back({"stress", "Pa", force / (width * scene_.gauge.thickness)});
  row.push_back({"force_imbalance", "N", grip_load[1] + grip_load[0]});
}

}  // namespace wale
