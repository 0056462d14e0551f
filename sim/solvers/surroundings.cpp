#include "sim/solvers/surroundings.hpp"

#include <cstdint>

#include "sim/cubes.hpp"

namespace wale {

std::vector<int> surroundings(const Points& q, const std::vector<int>& of, double reach) {
  const Cubes cubes(q, reach, static_cast<double>(q.cols()));
  std::vector<std::uint8_t> near(cubes.all(), 0);
  for (const int point : of) cubes.each_around(q.col(point), [&](std::size_t cube) { near[cube] = 1; });
  std::vector<int> found;
  for (int i = 0; i < q.cols(); ++i)
    if (near[cubes.flat(cubes.of(q.col(i)))]) found.push_back(i);
  return found;
}

}  // namespace wale
