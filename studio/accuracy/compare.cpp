#include "studio/accuracy/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "studio/accuracy/convergence.hpp"

namespace wale {
namespace {

Errors unknown_errors() {
  Errors errors;
  errors.fill(std::numeric_limits<double>::quiet_NaN());
  return errors;
}

/// Trials that ran, of a ladder that has an order also only those that rest as the finest does.
std::vector<const Trial*> comparable(const Ladder& ladder) {
  std::vector<const Trial*> found;
  for (auto trial = ladder.trials.rbegin(); trial != ladder.trials.rend(); ++trial)
    if (trial->found && (found.empty() || !rests_apart(difference(*trial->found, *found.front()->found))))
      found.push_back(&*trial);
  return found;  // from fine to coarse
}

Errors left_at(const Trial& coarse, const Trial& fine, double order) {
  Errors errors = difference(*coarse.found, *fine.found);
  for (double& error : errors) error = error_left(coarse.size, fine.size, error, order);
  return errors;
}

void set_own_errors(Ladder& ladder) {
  const std::vector<const Trial*> fine_first = comparable(ladder);
  const auto written = std::find_if(ladder.trials.begin(), ladder.trials.end(),
                                    [](const Trial& trial) { return trial.as_written && trial.found; });
  const Trial* limit = fine_first.empty() ? nullptr : fine_first.front();
  if (ladder.kind == Knob::Kind::choice) limit = written == ladder.trials.end() ? nullptr : &*written;
  for (Trial& trial : ladder.trials) {
    trial.own_error = unknown_errors();
    if (!trial.found || !limit) continue;
    trial.own_error = difference(*trial.found, *limit->found);
    if (&trial == limit && ladder.kind == Knob::Kind::resolution)
      trial.own_error =
          fine_first.size() < 2 ? unknown_errors() : left_at(*fine_first[1], trial, ladder.expected_order.value_or(1));
  }
}

void set_observed_order(Ladder& ladder) {
  const std::vector<const Trial*> fine_first = comparable(ladder);
  if (ladder.kind == Knob::Kind::choice || fine_first.size() < 3) return;
  const Trial &fine = *fine_first[0], &middle = *fine_first[1], &coarse = *fine_first[2];
  const double p =
      observed_order(coarse.size, middle.size, fine.size, difference(*coarse.found, *middle.found)[of_stress],
                     difference(*middle.found, *fine.found)[of_stress]);
  if (std::isfinite(p)) ladder.observed_order = p;
}

}  // namespace

void compare(Study& study) {
  const Ladder& together = study.ladders.back();
  std::vector<const Trial*> finest;  // that ran, from fine to coarse
  for (auto trial = together.trials.rbegin(); trial != together.trials.rend(); ++trial)
    if (trial->found) finest.push_back(&*trial);
  if (finest.empty()) return;
  const Measured reference = *finest[0]->found;
  study.reference = fmt::format("{} {}", finest[0]->label, together.noun);
  study.reference_error =
      finest.size() < 2 ? unknown_errors() : left_at(*finest[1], *finest[0], *together.expected_order);
  for (Ladder& ladder : study.ladders) {
    for (Trial& trial : ladder.trials) {
      trial.error = trial.found ? difference(*trial.found, reference) : unknown_errors();
      if (&trial == finest[0]) trial.error = study.reference_error;
      trial.rests_elsewhere = rests_apart(trial.error);
    }
    set_own_errors(ladder);
    set_observed_order(ladder);
  }
}

}  // namespace wale
