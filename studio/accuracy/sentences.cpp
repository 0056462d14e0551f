#include "studio/accuracy/sentences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wale {
namespace {

const Trial* written_of(const Ladder& ladder) {
  for (const Trial& trial : ladder.trials)
    if (trial.as_written && trial.found) return &trial;
  return nullptr;
}

std::string times_the_time(const Trial& trial, const Trial& than) {
  return fmt::format("{:.2g} times the time", trial.cost.processor / than.cost.processor);
}

std::string of_choice(const Ladder& ladder, const Trial& written) {
  std::string text;
  for (const Trial& trial : ladder.trials) {
    if (&trial == &written) continue;
    if (!text.empty()) text += "; ";
    text += fmt::format("{} instead of {}: ", trial.label, written.label);
    if (!trial.found)
      text += "it failed";
    else
      text += fmt::format("the answer moves by {}, {}{}", percent(headline(trial.own_error)),
                          times_the_time(trial, written), trial.found->intact ? "" : ", and yarn passes through yarn");
  }
  return text;
}

std::string step(const Ladder& ladder, const Trial& from, const Trial& to) {
  return fmt::format("{} instead of {}{}: error {} → {}, {}", to.label, from.label,
                     ladder.noun.empty() ? "" : " " + ladder.noun, percent(headline(from.own_error)),
                     percent(headline(to.own_error)), times_the_time(to, from));
}

}  // namespace

std::string percent(double share) {
  if (!std::isfinite(share)) return "unknown";
  return 100 * share < 1e-4 ? "0 %" : fmt::format("{:.2g} %", 100 * share);
}

double headline(const Errors& errors) {
  return std::isfinite(errors[of_stress]) ? errors[of_stress] : errors[of_position];
}

std::string sentence(const Ladder& ladder) {
  const Trial* written = written_of(ladder);
  if (!written) return "the scene as written did not run";
  if (ladder.kind == Knob::Kind::choice) return of_choice(ladder, *written);
  std::string text;
  const Trial* before = nullptr;
  for (const Trial& trial : ladder.trials) {
    if (!trial.found || trial.rests_elsewhere) continue;
    if (before && (&trial == written || before == written))
      text += (text.empty() ? "" : "; ") + step(ladder, *before, trial);
    before = &trial;
  }
  return text;
}

std::string summary_sentence(const Study& study) {
  const Trial* written = written_of(study.ladders.back());
  if (!written) return "The scene as written did not run.";
  return fmt::format(
      "As written the scene takes {:.3g} s of processor time and is {} off the reference ({}), which itself may be {} "
      "off.",
      written->cost.processor, percent(headline(written->error)), study.reference,
      percent(headline(study.reference_error)));
}

}  // namespace wale
