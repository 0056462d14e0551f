#include "sim/stage.hpp"

#include <algorithm>

#include "sim/deform.hpp"
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

Vec3 unit(Along along) { return along == Along::wale ? Vec3::UnitY() : Vec3::UnitX(); }

}  // namespace

Vec3 centre_of(const Fabric& fabric, const std::vector<int>& segments, const Points& q) {
  Vec3 sum = Vec3::Zero();
  for (const int i : segments) sum += combine(q, fabric.first_point(i), basis(0.5).value);
  return sum / std::max<double>(1, static_cast<double>(segments.size()));
}

StageSetup::StageSetup(const Scene& scene, const Stage& stage, const State& start, double tightened,
                       const Sizes& relaxed, const std::vector<double>& travels)
    : scene_(scene),
      stage_(stage),
      start_(start),
      relaxed_(relaxed),
      tightening_(stage.tighten ? Schedule::ramp(tightened, *stage.tighten, stage.duration) : Schedule(tightened)),
      effects_(stage.effects) {
  if (stage.hold == Hold::ends) hold_ends();
  if (stage.mount) mount_ends(travels);
  if (stage.pull) pull_ends();
}

void StageSetup::hold_ends() {
  const Points& q = start_.q;
  const double from = tightening_(0), to = tightening_(stage_.duration), share = mean_shrinkage(scene_.fabric);
  const double shrink = (1 + to * (share - 1)) / (1 + from * (share - 1));
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

std::unique_ptr<World> StageSetup::world() const {
  return std::make_unique<World>(scene_.fabric, effects_, tightening_, start_, scene_.clamps);
}

std::vector<Quantity> StageSetup::measure(World& world, const State& state) const {
  std::vector<Quantity> row{{"t", "s", state.t}};
  world.prepare(state);
  double grip_load[2] = {0, 0};
  const std::optional<Along> gripped = stage_.pull ? std::optional(stage_.pull->along) : stage_.mount;
  const Vec3 along = unit(gripped.value_or(Along::wale));
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
  if (!gripped) return row;
  // The machine reads what the fabric pulls on the moving grip; the other grip must read the same at rest.
  const double force = (grip_load[1] - grip_load[0]) / 2;
  const bool wale_wise = *gripped == Along::wale;
  const double width = wale_wise ? relaxed_.width : relaxed_.length;
  const int columns = wale_wise ? scene_.gauge.wales : scene_.gauge.courses;
  if (stage_.mount) row.push_back({"travel", "m", travel_(state.t)});
  if (stage_.pull) row.push_back({"strain", "1", travel_(state.t) / gauge_length_});
  row.push_back({"force", "N", force});
  row.push_back({"force_per_wale", "N", force / columns});
  row.push_back({"stress", "Pa", force / (width * scene_.gauge.thickness)});
  row.push_back({"force_imbalance", "N", grip_load[1] + grip_load[0]});
  return row;
}

}  // namespace wale
