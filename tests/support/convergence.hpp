/// The observed order of a method over a ladder of halvings.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <sstream>
#include <vector>

namespace wale {

struct Ladder {
  std::vector<double> size, error;

  /// Between the last two rungs; refine until that is in the asymptotic range.
  double order() const {
    const std::size_t n = error.size();
    return std::log(error[n - 2] / error[n - 1]) / std::log(size[n - 2] / size[n - 1]);
  }
  std::string print() const {
    std::ostringstream out;
    for (std::size_t i = 0; i < size.size(); ++i) out << "  size " << size[i] << "  error " << error[i] << '\n';
    return out.str();
  }
};

/// `error_at(h)` for h = size, size/2, ..., `rungs` times.
inline Ladder climb(double size, int rungs, const std::function<double(double)>& error_at) {
  Ladder ladder;
  for (int i = 0; i < rungs; ++i, size /= 2) {
    ladder.size.push_back(size);
    ladder.error.push_back(error_at(size));
  }
  return ladder;
}

}  // namespace wale
