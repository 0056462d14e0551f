/// The structures that a chart may call by name: jersey, garter, rib 2x1, seed, moss, basket 3x3.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/chart.hpp"

namespace wale {

/// The smallest piece that repeats: rows[0] is the first course, each from left to right, seen from the face.
struct StitchTile {
  std::vector<std::vector<Stitch>> rows;
};

/// A built-in structure; `_` counts as a space and case does not matter. Nothing if there is none of that name.
std::optional<StitchTile> built_in_stitch(std::string_view name);

/// Names as a user would write them, with typical numbers, for hints and listings.
const std::vector<std::string_view>& built_in_stitch_names();

}  // namespace wale
