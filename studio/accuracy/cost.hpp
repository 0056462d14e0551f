/// What it costs to do something: time and memory of this process.
#pragma once

#include <functional>
#include <vector>

namespace wale {

struct Cost {
  double wall = 0, processor = 0;  ///< s; the second is that of all threads
  double memory = 0;               ///< most that the process held meanwhile, MB; 0 where the system does not say
  long evaluations = 0, factorizations = 0;
};

/// Time and memory of `work`.
Cost cost_of(const std::function<void()>& work);

/// Each time the median of several; the rest is that of the last.
Cost median(std::vector<Cost>);

}  // namespace wale
