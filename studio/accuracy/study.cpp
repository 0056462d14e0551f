#include "studio/accuracy/study.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cmath>

#include "sim/run.hpp"
#include "studio/accuracy/compare.hpp"

namespace wale {
namespace {

/// Runs every trial once that is asked for, and the scene as written only once for all knobs.
class Trials {
 public:
  Trials(const SceneText& text, const StudyOptions& options, int of) : text_(text), options_(options), of_(of) {}

  Trial run_once(const Knob& knob, const Rung& rung) {
    if (options_.progress) options_.progress(done_, of_, fmt::format("{} {}", knob.key, rung.label));
    ++done_;
    if (rung.as_written && written_) return relabelled(*written_, rung);
    Trial trial{rung.label, rung.size, rung.as_written};
    Diagnostics say;
    const auto scene = text_.compile(rung.variant, say);
    if (!scene) {
      trial.failure = say.all().empty() ? "it does not compile" : say.all().back().message;
      return trial;
    }
    std::vector<Cost> costs;
    for (int time = 0; time < options_.times && !stopped() && trial.failure.empty(); ++time)
      costs.push_back(run_scene(*scene, trial));
    if (!costs.empty()) trial.cost = median(std::move(costs));
    if (rung.as_written && !stopped()) written_ = trial;
    return trial;
  }

  bool stopped() const { return options_.interrupt && options_.interrupt->load(); }

 private:
  static Trial relabelled(Trial trial, const Rung& rung) {
    trial.label = rung.label;
    trial.size = rung.size;
    return trial;
  }

  Cost run_scene(const Scene& scene, Trial& trial) const {
    Results results;
    results.scene = scene;
    Outcome outcome = Outcome::failed;
    Cost cost = cost_of([&] { outcome = run(results, {.progress = {}, .save = {}, .interrupt = options_.interrupt}); });
    cost.evaluations = results.effort.evaluations;
    cost.factorizations = results.effort.factorizations;
    if (outcome == Outcome::finished)
      trial.found = measured(results);
    else
      trial.failure = outcome == Outcome::interrupted ? "interrupted" : results.effort.failure;
    return cost;
  }

  const SceneText& text_;
  const StudyOptions& options_;
  std::optional<Trial> written_;
  int of_, done_ = 0;
};

}  // namespace

Study study(const SceneText& text, const std::string& name, std::vector<Knob> knobs, const Knob& together,
            const StudyOptions& options) {
  knobs.insert(knobs.begin(), together);  // an interrupted study has a reference first of all
  int of = 0;
  for (const Knob& knob : knobs) of += static_cast<int>(knob.rungs.size());

  Study study{.scene = name, .threads = omp_get_max_threads(), .times = options.times, .reference = {}};
  Trials trials(text, options, of);
  for (const Knob& knob : knobs) {
    Ladder ladder{knob.key, knob.noun, knob.kind, knob.order};
    for (const Rung& rung : knob.rungs) {
      Trial trial = trials.run_once(knob, rung);
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
