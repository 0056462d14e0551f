/// What `wale` answers to the shell; scripts depend on it.
#pragma once

namespace wale {

inline constexpr int success = 0;
inline constexpr int bad_input = 1;      ///< also: a file that cannot be read or written
inline constexpr int failed_solve = 2;   ///< no equilibrium, or no step small enough; what was done is saved
inline constexpr int interrupted = 130;  ///< by Ctrl-C; what was done is saved and can be resumed

}  // namespace wale
