#include "studio/choice/refinement.hpp"

#include <fmt/format.h>

#include "studio/accuracy/sentences.hpp"

namespace wale {
namespace {

class Refinement {
 public:
  Refinement(const SceneText& text, Settled& settled, Results& results, const RunOptions& options)
      : text_(text), settled_(settled), results_(results), options_(options) {}

  SecondLook look() {
    SecondLook look = look_again(text_, settled_, results_, options_);
    if (!interrupted()) results_.estimated_error = look.error;
    results_.phases.push_back({"check", look.seconds});
    return look;
  }

  bool wanted_after(const SecondLook& look) const {
    return is_too_far_off(look, settled_) && settled_.resolution->refinements < most_refinements && !interrupted();
  }

  std::optional<Settled> finer() const {
    Diagnostics said_before;
    return settle(text_, settled_.resolution->asked, said_before, settled_.resolution->refinements + 1);
  }

  /// Why it did not get to its end; empty if it did.
  std::string run_anew(Settled finer) {
    Results anew;
    anew.scene = std::move(finer.scene);
    anew.manifest = results_.manifest;
    anew.manifest.refinements = finer.resolution->refinements;
    anew.warnings = results_.warnings;
    anew.phases.push_back({"coarser runs", total_seconds(results_.phases)});
    const Outcome outcome = run(anew, {.progress = options_.progress, .interrupt = options_.interrupt});
    if (outcome != Outcome::finished) return interrupted() ? "it was interrupted" : anew.effort.failure;
    results_ = std::move(anew);
    settled_ = std::move(finer);
    return {};
  }

 private:
  bool interrupted() const { return options_.interrupt && options_.interrupt->load(); }

  const SceneText& text_;
  Settled& settled_;
  Results& results_;
  const RunOptions& options_;
};

}  // namespace

Refining look_and_refine(const SceneText& text, Settled& settled, Results& results, const RunOptions& options,
                         const std::function<void(const SecondLook&, const Settled&)>& announce) {
  Refining refining;
  if (!wants_second_look(settled)) return refining;
  Refinement refinement(text, settled, results, options);
  refining.looks.push_back(refinement.look());
  while (refining.failure.empty() && refinement.wanted_after(refining.looks.back())) {
    auto finer = refinement.finer();
    if (!finer) break;
    announce(refining.looks.back(), *finer);
    refining.failure = refinement.run_anew(std::move(*finer));
    if (refining.failure.empty()) refining.looks.push_back(refinement.look());
  }
  return refining;
}

std::string announcement(const SecondLook& before, const Settled& finer) {
  const Resolution& next = *finer.resolution;
  return fmt::format(
      "{} ({} asked for): run anew with {} segments a stitch and {} times the samples\n",
      before.error ? "Estimated error: " + percent(*before.error) : "No estimate of the error, as " + before.failure,
      percent(next.asked), next.segments_per_stitch, next.samples_times);
}

std::string words_of(const Refining& refining, const Settled& settled) {
  if (refining.looks.empty()) return {};
  std::string text = findings(refining.looks.back(), settled);
  if (!refining.failure.empty())
    text += fmt::format("A finer run did not get to its end: {}. These are the results of the one before\n",
                        refining.failure);
  return text;
}

}  // namespace wale
