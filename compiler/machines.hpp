/// What is known of the machines that programs name in their headers.
#pragma once

#include <string_view>

namespace wale {

struct MachineFacts {
  double most_racking = 4;         ///< needles, either way
  double gauge = 0;                ///< needles per inch, if the program does not say; 0: not known
  bool numbers_are_sizes = false;  ///< `x-stitch-number` is a stitch size, not a place in an operator's table
};

/// By the beginning of its name, whatever the case: "SWG091N2" is a Shima SWG, "kniterate" a Kniterate. Shima racks
/// by 8 needles, a Kniterate in practice by 2, most others by 4.
MachineFacts machine_facts(std::string_view machine);

/// A machine that programs are written for.
struct Target {
  std::string_view name;     ///< as a user asks for it
  std::string_view machine;  ///< as the header names it
  double gauge = 0;          ///< needles per inch
  int carriers = 0;          ///< named 1, 2, ...
  bool hook = false;         ///< yarn comes in and goes out by the inserting hook
};

/// Null if there is none of this name: "kniterate", "swg".
const Target* find_target(std::string_view name);

}  // namespace wale
