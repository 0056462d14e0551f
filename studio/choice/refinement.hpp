/// What is done when a run turns out to be further off than was asked.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "studio/choice/second_look.hpp"

namespace wale {

inline constexpr int most_refinements = 2;

struct Refining {
  std::vector<SecondLook> looks{};  ///< one a run, the last that of the results
  std::string failure{};            ///< why a finer run did not get to its end
};

/// Looks again after a run, and as long as it is_too_far_off() runs the scene anew in refined() settings: what it finds
/// takes the place of `settled` and `results`, with the estimated error. Both stay if a finer run is interrupted or
/// gives up. `announce` is told of every finer run before it starts. Uses `progress` and `interrupt` of the options.
Refining look_and_refine(const SceneText&, Settled& settled, Results& results, const RunOptions&,
                         const std::function<void(const SecondLook& before, const Settled& finer)>& announce);

/// What is announced: how far off a run is, and in what the scene runs anew.
std::string announcement(const SecondLook& before, const Settled& finer);

/// What was found in the end.
std::string words_of(const Refining&, const Settled&);

}  // namespace wale
