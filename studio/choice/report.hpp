/// What was chosen for a scene, in words and as one object.
#pragma once

#include <optional>
#include <string>

#include "studio/choice/second_look.hpp"

namespace wale {

/// Settings and decisions; empty if the scene left nothing open.
std::string words_of(const Settled&);

/// `{accuracy: {asked, expected, estimated, segments_per_stitch, ...}, decisions: [...]}`, in SI units.
std::string choices_json(const Settled&, const std::optional<SecondLook>&);

}  // namespace wale
