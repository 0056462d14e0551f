#include "studio/choice/second_look.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/front/limits.hpp"
#include "studio/accuracy/common_rest.hpp"
#include "studio/accuracy/convergence.hpp"
#include "studio/accuracy/cost.hpp"
#include "studio/accuracy/measured.hpp"
#include "studio/accuracy/sentences.hpp"

namespace wale {
namespace {

constexpr double order = 2;

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

  /// Nothing, and why in failure(), if it does not get to its end.
  std::optional<Measured> run(const Scene& scene, const std::string& what) {
    Results results;
    results.scene = scene;
    RunOptions options;
    options.progress = [&](RunStatus status) {
      status.stage = what;
      if (options_.progress) options_.progress(status);
    };
    options.interrupt = options_.interrupt;
    if (rest_) options.begin = begin_at(*rest_, scene);
    const Outcome outcome = wale::run(results, options);
    if (outcome == Outcome::finished) return measured(results);
    failure_ = outcome == Outcome::interrupted ? "it was interrupted" : results.effort.failure;
    return std::nullopt;
  }

  bool rest_rubs() const { return rest_ && rest_->rubs; }
  const std::string& failure() const { return failure_; }

 private:
  std::optional<Rest> rest_;
  const RunOptions& options_;
  std::string failure_;
};

/// In that stage, and in those before it where it was left out as well: what acts at rest has its say in the pull.
Scene with(Scene scene, const std::vector<Decision>& decisions, const Decision& added) {
  for (const Decision& each : decisions)
    if (each.left_out && each.effect == added.effect && each.stage <= added.stage)
      scene.stages[static_cast<std::size_t>(each.stage)].effects.push_back(*each.left_out);
  return scene;
}

void estimate(SecondLook& look, const Measured& fine, const Measured& coarse, int segments) {
  const Errors apart = difference(coarse, fine);
  if (rests_apart(apart)) {
    look.failure = "the second solution rests in another state";
    return;
  }
  look.error = error_left(1.0 / look.segments, 1.0 / segments, told(apart), order);
}

}  // namespace

bool wants_second_look(const Settled& settled) {
  return settled.resolution || std::any_of(settled.decisions.begin(), settled.decisions.end(),
                                           [&](auto& decision) { return is_borderline(decision, settled.accuracy); });
}

SecondLook look_again(const SceneText& text, Settled& settled, const Results& run, const RunOptions& options) {
  SecondLook look{.segments = coarser(settled.segments)};
  const auto scene = in_other_segments(text, settled, look.segments);
  if (!scene) return look;
  const Cost cost = cost_of([&] {
    Looking looking(run, options);
    look.of_pull_only = looking.rest_rubs();
    const std::optional<Measured> coarse = looking.run(*scene, "check");
    look.failure = looking.failure();
    if (!coarse) return;
    estimate(look, measured(run), *coarse, settled.segments);
    for (Decision& decision : settled.decisions) {
      if (!is_borderline(decision, settled.accuracy)) continue;
      const auto changed = looking.run(with(*scene, settled.decisions, decision), "with " + decision.effect);
      if (changed) decision.seen = told(difference(*changed, *coarse));
    }
  });
  look.seconds = cost.wall;
  double first = 0;
  for (const Phase& phase : run.phases) first += phase.seconds;
  look.share_of_run = look.seconds / first;
  return look;
}

std::string words_of(const SecondLook& look, const Settled& settled) {
  std::string text;
  if (settled.resolution) {
    const double asked = settled.resolution->asked;
    if (look.error)
      text += fmt::format("Estimated error: {} ({} asked for), by a second solution with {} segments a stitch{}{}\n",
                          percent(*look.error), percent(asked), look.segments,
                          look.of_pull_only ? " from the same rest; with friction that depends on how it was reached, "
                                              "which can be far more and is not in this number"
                                            : "",
                          *look.error > asked ? ". THIS IS MORE THAN WAS ASKED FOR: ask for less, and compare" : "");
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
