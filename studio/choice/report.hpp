/// What was chosen for a scene, in words and as one object.
#pragma once

#include <string>

#include "studio/choice/refinement.hpp"

namespace wale {

/// Settings and decisions; empty if the scene left nothing open.
std::string words_of(const Settled&);

/// `{accuracy: {asked, segments_per_stitch, ...}, second_solution: {...}, before_refinement: [...], effects: [...]}`,
/// in SI units.
std::string choices_json(const Settled&, const Refining&);

}  // namespace wale
