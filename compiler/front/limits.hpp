/// Sizes beyond which a chart or a program is taken for a slip of the pen.
#pragma once

#include <cstddef>

namespace wale::limits {

inline constexpr int most_wales = 10'000;
inline constexpr int most_courses = 10'000;
inline constexpr long most_cells = 4'000'000;
inline constexpr double least_stitch_length = 1e-4, most_stitch_length = 1;  ///< m
inline constexpr double least_diameter = 1e-6, most_diameter = 0.1;          ///< m
inline constexpr int least_segments = 8, most_segments = 200;                ///< a stitch
inline constexpr std::size_t most_instructions = 2'000'000;
inline constexpr std::size_t most_carriers = 100;
inline constexpr std::size_t most_headers = 200;
inline constexpr std::size_t longest_name = 100;  ///< of a carrier, bytes
inline constexpr double finest_gauge = 100;       ///< needles per inch
/// A jersey of hard tubes jams at this stitch length over contact diameter.
inline constexpr double jamming_ratio = 13.27;

}  // namespace wale::limits
