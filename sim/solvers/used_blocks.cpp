#include "sim/solvers/used_blocks.hpp"

#include <algorithm>
#include <functional>

namespace wale {
namespace {

constexpr double most_idle = 1.3;  // blocks that are kept in the pattern, over those that are used

long how_many(const std::vector<char>& used) { return std::count(used.begin(), used.end(), 1); }

}  // namespace

bool UsedBlocks::update(const Stiffness& K) {
  std::vector<char> used(K.slots());
  for (std::size_t slot = 0; slot < used.size(); ++slot) used[slot] = !K.at(static_cast<int>(slot)).isZero(0);
  used_.resize(used.size());
  const auto is_covered = [](char now, char before) { return now <= before; };
  if (looked_ && std::equal(used.begin(), used.end(), used_.begin(), is_covered)) return false;
  // What was used before may well come back: yarns touch and part again.
  std::transform(used.begin(), used.end(), used_.begin(), used_.begin(), std::bit_or<char>());
  if (static_cast<double>(how_many(used_)) > most_idle * static_cast<double>(how_many(used))) used_ = used;
  looked_ = true;
  return true;
}

}  // namespace wale
