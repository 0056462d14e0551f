#include "studio/accuracy/study.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cmath>

#include "sim/run.hpp"
#include "studio/accuracy/common_rest.hpp"
#include "studio/accuracy/compare.hpp"

namespace wale {
namespace {

/// Runs every trial that is asked for: as a whole for its cost, and then from the rest of the scene as written, which
/// runs first and only once.
class Trials {
 public:
  Trials(const SceneText& text, const StudyOptions& options, int of) : text_(text), options_(options), of_(of) {}

  void run_as_written() {
    Rung rung{"as written", 0};
    rung.as_written = true;
    written_ = run_once({}, rung);
  }

  Trial trial(const Knob& knob, const Rung& rung) {
    Trial trial = rung.as_written ? *written_ : recalled_or_run(knob, rung);
    trial.label = rung.label;
    trial.size = rung.size;
    return trial;
  }

  bool stopped() const { return options_.interrupt && options_.interrupt->load(); }

 private:
  Trial recalled_or_run(const Knob& knob, const Rung& rung) {
    if (auto before = options_.recall ? options_.recall(knob, rung) : std::nullopt) {
      ++done_;
      return *before;
    }
    Trial trial = run_once(knob, rung);
    if (options_.keep && !stopped()) options_.keep(knob, trial);
    return trial;
  }

  Trial run_once(const Knob& knob, const Rung& rung) {
    if (options_.progress) options_.progress(done_, of_, fmt::format("{} {}", knob.key, rung.label));
    ++done_;
    Trial trial{rung.label, rung.size, rung.as_written};
    Diagnostics say;
    const auto scene = text_.compile(rung.variant, say);
    if (!scene) {
      trial.failure = say.all().empty() ? "it does not compile" : say.all().back().message;
      return trial;
    }
    std::vector<Cost> costs;
    for (int time = 0; time < options_.times && !stopped() && trial.failure.empty(); ++time)
      costs.push_back(run_whole(*scene, trial));
    if (!costs.empty()) trial.cost = median(std::move(costs));
    if (trial.found && !rung.as_written && !knob.finds_rest && !stopped()) run_from_common_rest(*scene, trial);
    return trial;
  }

  Cost run_whole(const Scene& scene, Trial& trial) {
    Results results;
    results.scene = scene;
    Outcome outcome = Outcome::failed;
    Cost cost = cost_of([&] { outcome = run(results, options()); });
    cost.evaluations = results.effort.evaluations;
    cost.factorizations = results.effort.factorizations;
    if (outcome == Outcome::finished)
      trial.found = measured(results);
    else
      trial.failure = outcome == Outcome::interrupted ? "interrupted" : results.effort.failure;
    if (trial.as_written) rest_ = rest_of(results);
    return cost;
  }

  /// What the whole run found stays if this does not work out.
  void run_from_common_rest(const Scene& scene, Trial& trial) const {
    if (!rest_ || !begin_at(*rest_, scene)) return;
    Found from_rest = run_from(rest_, scene, options());
    if (!from_rest.measured) return;
    trial.finds_another_rest = rests_apart(difference(*trial.found, *from_rest.measured));
    trial.found = std::move(from_rest.measured);
  }

  RunOptions options() const { return {.interrupt = options_.interrupt}; }

  const SceneText& text_;
  const StudyOptions& options_;
  std::optional<Trial> written_;
  std::optional<Rest> rest_;
  int of_, done_ = 0;
};

}  // namespace

Study study(const SceneText& text, const std::string& name, std::vector<Knob> knobs, const Knob& together,
            const StudyOptions& options) {
  knobs.insert(knobs.begin(), together);  // an interrupted study has a reference first of all
  int of = 1;
  for (const Knob& knob : knobs)
    of += static_cast<int>(
        std::count_if(knob.rungs.begin(), knob.rungs.end(), [](const Rung& rung) { return !rung.as_written; }));

  Study study{.scene = name, .threads = omp_get_max_threads(), .times = options.times, .reference = {}};
  Trials trials(text, options, of);
  trials.run_as_written();
  for (const Knob& knob : knobs) {
    Ladder ladder{knob.key, knob.noun, knob.kind, knob.order};
    for (const Rung& rung : knob.rungs) {
      Trial trial = trials.trial(knob, rung);
      if (trials.stopped()) break;
      ladder.trials.push_back(std::move(trial));
    }
    study.ladders.push_back(std::move(ladder));
    if (trials.stopped()) break;
  }
  study.complete = !trials.stopped();
  std::rotate(study.ladders.begin(), study.ladders.begin() + 1, study.ladders.end());
  compare(study);
  return study;
}

}  // namespace wale
