#include "sim/run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "sim/clasps.hpp"
#include "sim/deform.hpp"
#include "sim/detour.hpp"
#include "sim/effects/beads.hpp"
#include "sim/image.hpp"
#include "sim/mount.hpp"
#include "sim/results/curves.hpp"
#include "sim/results/topology.hpp"
#include "sim/solvers/clearance.hpp"
#include "sim/solvers/even_motion.hpp"
#include "sim/stage.hpp"
#include "sim/tile.hpp"

namespace wale {
namespace {

constexpr int most_rounds = 4;
constexpr double least_of_allowed = 0.05;  // of a residual that a light load asks for

/// A solver's steps, given as shares of a stage, in seconds.
QuasiStatic timed(QuasiStatic spec, double duration) {
  spec.first_step *= duration;
  spec.smallest_step *= duration;
  return spec;
}
RungeKutta timed(const RungeKutta& spec, double) { return spec; }
Implicit timed(const Implicit& spec, double) { return spec; }

/// Runs one scene into one Results, from wherever its snapshots end.
class Run {
 public:
  Run(Results& results, const RunOptions& options)
      : results_(results),
        options_(options),
        plain_(plain(results.scene.fabric, at_rest(results.scene.fabric).q)),
        clasps_(plain_, results.scene.crossings),
        half_diameter_(thinnest_diameter(results.scene.fabric) / 2) {
    for (const Snapshot& snapshot : results.snapshots) follow(snapshot.state.q);
  }

  Outcome all() {
    const int stages = static_cast<int>(results_.scene.stages.size());
    if (results_.snapshots.empty()) {
      const Beginning from = options_.begin.value_or(Beginning{0, at_rest(results_.scene.fabric)});
      begin(from.stage, from.state);
    }
    for (int stage = results_.snapshots.back().stage; stage < stages; ++stage) {
      if (results_.snapshots.back().stage < stage) begin(stage, results_.snapshots.back().state);
      const Outcome outcome = one(stage);
      if (outcome != Outcome::finished) return outcome;
    }
    results_.complete = true;
    return Outcome::finished;
  }

 private:
  /// Where clasps_ looked, and what it found.
  struct Looked {
    Points at;
    Clasps::Places places;
  };

  /// As Scene::crossings count segments.
  static Fabric plain(const Fabric& fabric, const Points& q) {
    if (!fabric.cell) return fabric;
    // Rolled out, loops hold each other as they do around an axis.
    const bool curls = fabric.cell->may_curl();
    return tile(fabric, curls ? rolled_out(*fabric.cell, q) : q, repeats_for_crossings, repeats_for_crossings);
  }
  std::vector<bool> follow(const Points& q) {
    const Fabric& fabric = results_.scene.fabric;
    followed_ = q;
    return clasps_.follow(fabric.cell ? plain(fabric, q).points : q);
  }

  /// A loop is several diameters of yarn long, so that little can have slid where nothing has moved by half of one, but
  /// for what all of the fabric does.
  bool slid(const Points& q) const {
    return largest_motion(followed_, q) >= half_diameter_ &&
           uneven_motion_nearby(results_.scene.fabric, followed_, q - followed_) >= half_diameter_;
  }

  /// Of a step on its way to `q`. One that was given up is tried anew from `before`.
  void keep_up(const Points& q, const Looked& before) {
    if (largest_motion(before.at, q) < largest_motion(followed_, q)) {
      clasps_.go_back(before.places);
      followed_ = before.at;
    }
    if (slid(q)) follow(q);
  }

  const Stage& stage_at(int index) const { return results_.scene.stages[static_cast<std::size_t>(index)]; }

  /// The state that a stage starts from, as its snapshot 0.
  void begin(int stage, State state) {
    state.t = 0;
    state.step = 0;
    state.v.setZero();
    state.a = {};
    results_.snapshots.push_back({stage, 0, std::move(state)});
    const Stage& of = stage_at(stage);
    // Once gripped a fabric no longer lies as it relaxed.
    const bool gripped_before = stage > 0 && stage_at(stage - 1).grips();
    if (of.grips() && !gripped_before)
      results_.relaxed = measure(results_.scene.fabric, results_.scene.gauge, results_.snapshots.back().state.q);
    const StageSetup setup(results_.scene, of, start_of(stage), rest_lengths_before(results_.scene, stage),
                           results_.relaxed);
    residual_.reset();
    record(stage, setup, start_of(stage));
  }

  const State& start_of(int stage) const {
    for (const Snapshot& snapshot : results_.snapshots)
      if (snapshot.stage == stage && snapshot.sample == 0) return snapshot.state;
    return results_.snapshots.back().state;
  }

  int samples_done(int stage) const {
    int done = 0;
    for (const Snapshot& snapshot : results_.snapshots)
      if (snapshot.stage == stage && snapshot.sample > done) done = snapshot.sample;
    return done;
  }

  Outcome one(int index) {
    const Stage& stage = stage_at(index);
    const State start = start_of(index);
    State state = results_.snapshots.back().state;
    if (results_.snapshots.back().sample < 0) results_.snapshots.pop_back();
    for (int sample = samples_done(index) + 1; sample <= stage.samples; ++sample) {
      const StageSetup setup(results_.scene, stage, start, rest_lengths_before(results_.scene, index), results_.relaxed,
                             travels_to(index));
      const auto begun = std::chrono::steady_clock::now();
      Outcome outcome = Outcome::finished;
      for (const double stop : stops(stage, state.t, stage.duration * sample / stage.samples))
        if (outcome == Outcome::finished) outcome = until(index, setup, stop, state);
      spend(stage.name, begun);
      const State& saved = results_.snapshots.back().state;
      const bool moved = state.t > saved.t || state.q != saved.q;
      if (outcome == Outcome::interrupted || (outcome == Outcome::failed && moved))
        results_.snapshots.push_back({index, -1, state});
      if (outcome != Outcome::finished) return outcome;
      results_.snapshots.push_back({index, sample, state});
      record(index, setup, state);
      if (options_.save) options_.save(results_);
    }
    return Outcome::finished;
  }

  /// Where strains turn on the way, and where it ends: a turn that were stepped over would not be reached.
  static std::vector<double> stops(const Stage& stage, double from, double to) {
    const double near = 1e-9 * stage.duration;
    std::vector<double> stops;
    for (const double turn : turns_of(stage))
      if (turn > from + near && turn < to - near) stops.push_back(turn);
    stops.push_back(to);
    return stops;
  }

  /// How far apart the grips of a mount have stood at each sample so far, and where they go for the next one.
  std::vector<double> travels_to(int index) const {
    if (!stage_at(index).mount) return {0};
    const StageSetup closed(results_.scene, stage_at(index), start_of(index), 0, results_.relaxed);
    const Table& table = results_.samples;
    std::vector<double> travels{0};
    std::vector<Mounted> tried;
    for (std::size_t row = 0; row < table.rows(); ++row) {
      if (table.find("stage")->values[row] != index) continue;
      const double travel = table.find("travel")->values[row];
      // The first row is of grips that have only just closed, and read nothing.
      if (table.find("t")->values[row] == 0) continue;
      travels.push_back(travel);
      tried.push_back({travel, table.find("force")->values[row]});
    }
    travels.push_back(next_travel(tried, closed.gauge_length(), unread(stage_at(index))));
    return travels;
  }

  /// What grips may read of residual forces, as large as is allowed, on every wale or course between them, N.
  double unread(const Stage& stage) const {
    const auto* spec = std::get_if<QuasiStatic>(&stage.solver);
    if (!spec) return 0;
    const int columns = stage.mount == Along::wale ? results_.scene.gauge.wales : results_.scene.gauge.courses;
    return allowed_residual(*spec, results_.scene.fabric) * columns;
  }

  /// To `t`, if need be from where another contact law is balanced there.
  Outcome until(int index, const StageSetup& setup, double t, State& state) {
    const Outcome outcome = straight_to(index, setup, t, state);
    if (outcome != Outcome::failed) return outcome;
    const std::string failure = results_.effort.failure;
    State beside = state;
    Outcome detour = take_detour(index, t, beside);
    if (detour == Outcome::finished) detour = straight_to(index, setup, t, beside);
    if (detour == Outcome::finished) {
      ++results_.effort.retries.detoured;
      state = std::move(beside);
    } else if (detour == Outcome::failed) {
      results_.effort.failure = failure;
    }
    return detour;
  }

  /// Moves `state` to where it would be balanced at `t` by another law, but leaves it at its own time.
  Outcome take_detour(int index, double t, State& state) {
    const Stage& stage = stage_at(index);
    const auto* spec = std::get_if<QuasiStatic>(&stage.solver);
    const std::optional<Scene> other = spec ? by_another_law(results_.scene, stage) : std::nullopt;
    if (!other) return Outcome::failed;
    const StageSetup setup(*other, stage, start_of(index), rest_lengths_before(results_.scene, index), results_.relaxed,
                           travels_to(index));
    const auto world = setup.world();
    const auto solver = make(timed(*spec, stage.duration), *world, state);
    const Outcome outcome = go(index, *world, *solver, t);
    add_effort(solver->effort());
    state.q = solver->state().q;
    state.v.setZero();
    return outcome;
  }

  /// Each sample starts from nothing but its state, so that a resumed run does as an uninterrupted one.
  Outcome straight_to(int index, const StageSetup& setup, double t, State& state) {
    const auto world = setup.world();
    const auto solver =
        std::visit([&](const auto& spec) { return make(timed(spec, stage_at(index).duration), *world, state); },
                   stage_at(index).solver);
    const Outcome outcome = go(index, *world, *solver, t);
    state = solver->state();
    // A sample that is not balanced to its end would not be balanced on when it is taken up: an interruption waits.
    world->heed(nullptr);
    if (outcome == Outcome::finished) sharpen(index, setup, *solver, state);
    add_effort(solver->effort());
    return outcome;
  }

  /// Step by step, with an eye on every loop.
  Outcome go(int index, World& world, Solver& solver, double t) {
    world.heed(options_.interrupt);
    world.watch([this](const Points& q) { keep_up(q, before_step_); });
    while (true) {
      before_step_ = {followed_, clasps_.places()};
      const Progress progress = solver.advance(t);
      keep_up(solver.state().q, before_step_);
      residual_ = solver.residual();
      tell(index, solver.state().t);
      if (progress == Progress::failed) return Outcome::failed;
      if (progress == Progress::arrived) return Outcome::finished;
      if (options_.interrupt && options_.interrupt->load()) return Outcome::interrupted;
    }
  }

  /// Balances a pulled fabric until what is left is small beside the load on one wale or course.
  void sharpen(int index, const StageSetup& setup, Solver& solver, State& state) {
    const auto* spec = std::get_if<QuasiStatic>(&stage_at(index).solver);
    if (!spec || !stage_at(index).pull || !residual_) return;
    const double allowed = allowed_residual(*spec, results_.scene.fabric);
    for (int round = 0; round < most_rounds; ++round) {  // the load changes with the balance
      const auto measured = setup.measure(*setup.world_to_measure(), state);
      const auto load = std::find_if(measured.begin(), measured.end(),
                                     [](const Quantity& quantity) { return quantity.name == "force_per_wale"; });
      const double wanted = std::clamp(spec->of_load * std::abs(load->value), least_of_allowed * allowed, allowed);
      if (*residual_ <= wanted) return;
      const bool found = solver.sharpen(wanted);
      state = solver.state();
      residual_ = solver.residual();
      if (!found) return;
    }
  }

  void record(int index, const StageSetup& setup, const State& state) {
    const auto world = setup.world_to_measure();
    std::vector<Quantity> row{{"stage", "1", static_cast<double>(index)}};
    const auto measured = setup.measure(*world, state);
    row.insert(row.end(), measured.begin(), measured.end());
    if (residual_) row.push_back({"residual", "N", *residual_});
    append_row(results_.samples, row);
    results_.topology = worse(results_.topology, tally(follow(state.q)));
    if (!world->parts().made_beads.empty())
      results_.contact_samples = world->parts().made_beads.begin()->second->total();
  }

  void add_effort(const Effort& effort) {
    results_.effort.accepted += effort.accepted;
    results_.effort.rejected += effort.rejected;
    results_.effort.evaluations += effort.evaluations;
    results_.effort.spared += effort.spared;
    results_.effort.factorizations += effort.factorizations;
    results_.effort.retries.halved += effort.retries.halved;
    results_.effort.retries.continued += effort.retries.continued;
    results_.effort.retries.damped += effort.retries.damped;
    results_.effort.retries.detoured += effort.retries.detoured;
    results_.effort.failure = effort.failure;
  }

  void spend(const std::string& phase, std::chrono::steady_clock::time_point since) {
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
    if (results_.phases.empty() || results_.phases.back().name != phase) results_.phases.push_back({phase, 0});
    results_.phases.back().seconds += seconds;
  }

  void tell(int index, double t) const {
    if (!options_.progress) return;
    const Stage& stage = stage_at(index);
    options_.progress(
        {stage.name, index, static_cast<int>(results_.scene.stages.size()), t / stage.duration, residual_, &results_});
  }

  Results& results_;
  const RunOptions& options_;
  Fabric plain_;
  Clasps clasps_;
  Points followed_;  // where clasps_ last looked
  Looked before_step_;
  double half_diameter_;            // m
  std::optional<double> residual_;  // Solver::residual() after the last step of this stage, N
};

}  // namespace

Outcome run(Results& results, const RunOptions& options) { return Run(results, options).all(); }

}  // namespace wale
