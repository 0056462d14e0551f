/// What accuracy costs: a scene run again and again, one knob turned at a time, then all together.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "studio/accuracy/cost.hpp"
#include "studio/accuracy/knobs.hpp"
#include "studio/accuracy/measured.hpp"

namespace wale {

/// One run of a study.
struct Trial {
  std::string label;
  double size = 0;  ///< see Rung
  bool as_written = false;
  std::optional<Measured> found{};  ///< nothing if the run failed
  std::string failure{};            ///< then why
  Cost cost{};
  Errors error{};      ///< against the reference of the study
  Errors own_error{};  ///< against the finest of its knob (Richardson's estimate for that itself); of a choice,
                       ///< against the scene as written
  bool finds_another_rest = false;  ///< left to itself it comes to rest in another of several equilibria than that of
                                    ///< the scene as written, from which `found` begins
  bool rests_elsewhere = false;     ///< `found` does not rest as the reference does
};

/// The trials of one knob, from coarse to fine.
struct Ladder {
  std::string key, noun;
  Knob::Kind kind = Knob::Kind::resolution;
  std::optional<double> expected_order{};
  std::optional<double> observed_order{};  ///< of the stress, by the three finest that rest alike
  std::vector<Trial> trials{};
};

struct Study {
  std::string scene;
  int threads = 1, times = 1;
  std::string reference;          ///< what the reference is
  Errors reference_error{};       ///< Richardson's estimate from the two finest of `together`
  std::vector<Ladder> ladders{};  ///< the last one is `together`
  bool complete = false;
};

struct StudyOptions {
  int times = 1;  ///< runs of each, of which the times are medians
  std::function<void(int done, int of, const std::string& what)> progress{};
  const std::atomic<bool>* interrupt = nullptr;
  /// What a rung gave when it ran before; may be empty. The scene as written always runs, for its rest.
  std::function<std::optional<Trial>(const Knob&, const Rung&)> recall{};
  std::function<void(const Knob&, const Trial&)> keep{};  ///< after every other; may be empty
};

/// Runs the rungs of some knobs, and of `together`, and compares. An interrupted study holds what was done.
Study study(const SceneText&, const std::string& name, std::vector<Knob> knobs, const Knob& together,
            const StudyOptions&);

}  // namespace wale
