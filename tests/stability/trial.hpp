/// One rung of a hard case, run by one solver with one law of contact, and judged.
#pragma once

#include <string>

#include "sim/run.hpp"
#include "tests/stability/hard_case.hpp"

namespace wale::stability {

struct Verdict {
  enum class End : std::uint8_t {
    held,     ///< it came to its end, and all holds
    gave_up,  ///< it said so, in words, and all that it left holds
    broke,    ///< something does not hold
    too_long  ///< nothing wrong until it was stopped
  };
  End end = End::held;
  std::string what{};  ///< in words, unless it held
  bool held() const { return end == End::held; }
};

/// When to stop a run that takes too long; both are without bound if zero.
struct Patience {
  long steps = 0;
  double seconds = 0;
};

/// The case at a rung with this solver in its tested stages, and this law in all its materials.
HardScene hard_scene(const HardCase&, double rung, SolverKind, ContactLaw);
/// The solver that the ladder uses.
SolverSpec solver_of(SolverKind);

/// Runs it to its end, or goes on from where `results` stand, and judges what it has left.
Verdict attempt(const HardScene&, Results& results, const Patience& = {});

}  // namespace wale::stability
