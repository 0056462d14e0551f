/// Which part of a knitted piece is wanted.
#pragma once

#include <optional>
#include <string_view>

namespace wale {

/// From the first to the last, both included.
struct IntRange {
  int first = 0, last = 0;
  bool holds(int value) const { return value >= first && value <= last; }
};

/// "5-20" or "-3--1"; "7" is a range of one.
std::optional<IntRange> parse_range(std::string_view text);

struct Crop {
  std::optional<IntRange> courses;  ///< from 1, as courses_of() counts them from 0
  std::optional<IntRange> needles;  ///< where loops were made, on any bed
};

}  // namespace wale
