/// How nearly the forces of a run balance, beside what was asked for and beside the load.
#pragma once

#include <string>
#include <vector>

#include "sim/results/results.hpp"

namespace wale {

/// Of a quasi-static stage, as far as it was run.
struct Balance {
  std::string stage;
  double residual = 0;   ///< the largest force on a control point that nothing balances, at any sample, N
  double tolerance = 0;  ///< what it had to be below, N
  double load = 0;       ///< the largest on a wale (on a course, if along those) that is pulled or deformed, N; else 0
  Along along = Along::wale;  ///< which of the two

  /// The residual over the load; NaN without a load.
  double share() const;
};

/// One a quasi-static stage that has come to a sample, in order. Scene::stages must be there.
std::vector<Balance> balances(const Results&);

}  // namespace wale
