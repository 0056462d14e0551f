#include "studio/choice/second_look.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/front/limits.hpp"
#include "studio/accuracy/adjust.hpp"
#include "studio/accuracy/common_rest.hpp"
#include "studio/accuracy/cost.hpp"
#include "studio/accuracy/measured.hpp"
#include "studio/accuracy/sentences.hpp"

namespace wale {
namespace {

int coarser(int segments) {
  return std::max(limits::least_segments, 2 * static_cast<int>(std::lround(segments / 3.0)));
}

/// What accuracy is told of: the stress, or of a fabric that only rests its spacings.
double told(const Errors& errors) {
  return std::isfinite(errors[of_stress]) ? errors[of_stress]
                                          : std::max(errors[of_course_spacing], errors[of_wale_spacing]);
}

class Looking {
 public:
  Looking(const Results& run, const RunOptions& options) : rest_(rest_of(run)), options_(options) {}

  Found run(const Scene& scene, const std::string& what) const {
    RunOptions options;
    options.progress = [&](RunStatus status) {
      status.stage = what;
      if (options_.progress) options_.progress(status);
    };
    options.interrupt = options_.interrupt;
    return run_from(rest_, scene, options);
  }

  bool rest_rubs() const { return rest_ && rest_->rubs; }

 private:
  std::optional<Rest> rest_;
  const RunOptions& options_;
};

/// In that stage, and in those before it where it was left out as well: what acts at rest has its say in the pull.
Scene with(Scene scene, const std::vector<Decision>& decisions, const Decision& added) {
  for (const Decision& each : decisions)
    if (each.left_out && each.effect == added.effect && each.stage <= added.stage)
      scene.stages[static_cast<std::size_t>(each.stage)].effects.push_back(*each.left_out);
  return scene;
}

/// Two thirds of the segments and half the samples leave at least twice the error, so that the two differ by more than
/// the finer one errs.
void estimate(SecondLook& look, const Measured& fine, const Measured& coarse) {
  const Errors apart = difference(coarse, fine);
  if (rests_apart(apart))
    look.failure = "the second solution rests in another state";
  else
    look.error = told(apart);
}

}  // namespace

bool wants_second_look(const Settled& settled) {
  return settled.resolution || std::any_of(settled.decisions.begin(), settled.decisions.end(),
                                           [&](auto& decision) { return is_borderline(decision, settled.accuracy); });
}

bool is_too_far_off(const SecondLook& look, const Settled& settled) {
  return settled.resolution && !(look.error && *look.error <= settled.resolution->asked);
}

SecondLook look_again(const SceneText& text, Settled& settled, const Results& run, const RunOptions& options) {
  SecondLook look{.segments = coarser(settled.segments)};
  auto scene = in_other_segments(text, settled, look.segments);
  if (!scene) return look;
  halve_samples(*scene);
  const Cost cost = cost_of([&] {
    const Looking looking(run, options);
    look.of_pull_only = looking.rest_rubs();
    const Found coarse = looking.run(*scene, "check");
    look.failure = coarse.failure;
    if (!coarse.measured) return;
    estimate(look, measured(run), *coarse.measured);
    for (Decision& decision : settled.decisions) {
      if (!is_borderline(decision, settled.accuracy)) continue;
      const Found changed = looking.run(with(*scene, settled.decisions, decision), "with " + decision.effect);
      if (changed.measured) decision.seen = told(difference(*changed.measured, *coarse.measured));
    }
  });
  look.seconds = cost.wall;
  look.share_of_run = look.seconds / total_seconds(run.phases);
  return look;
}

std::string findings(const SecondLook& look, const Settled& settled) {
  std::string text;
  if (settled.resolution) {
    const double asked = settled.resolution->asked;
    if (look.error)
      text += fmt::format(
          "Estimated error: {} ({} asked for), by a second solution with {} segments a stitch and half the "
          "samples{}{}\n",
          percent(*look.error), percent(asked), look.segments,
          look.of_pull_only ? " from the same rest; with friction that depends on how it was reached, "
                              "which can be far more and is not in this number"
                            : "",
          is_too_far_off(look, settled) ? ". THIS IS MORE THAN WAS ASKED FOR" : "");
    else
      text += fmt::format("No estimate of the error: {}\n", look.failure);
  }
  for (const Decision& decision : settled.decisions)
    if (decision.seen)
      text += fmt::format("{} was left out of \"{}\" ({} estimated); with it the answer changes by {}\n",
                          decision.effect, decision.stage_name, percent(*decision.estimate), percent(*decision.seen));
  return text;
}

}  // namespace wale
