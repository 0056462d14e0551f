#include "sim/cyclic_band.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "sim/mass.hpp"

namespace wale {
namespace {

/// Of four segments on every unknown is a neighbour of every other.
TEST(CyclicBand, SolvesAsTheFullMatrixDoes) {
  for (const int n : {4, 5, 6, 7, 12}) {
    std::vector<double> weight;
    for (int i = 0; i < n; ++i) weight.push_back(1 + 0.3 * i);
    const Eigen::MatrixXd open = mass_band(weight);
    Eigen::MatrixXd full = Eigen::MatrixXd::Zero(n, n);
    for (int j = 0; j < n + 3; ++j)
      for (int k = 0; k < 4 && j + k < n + 3; ++k) {
        full((j + k) % n, j % n) += open(k, j);
        if (k > 0) full(j % n, (j + k) % n) += open(k, j);
      }
    const Eigen::MatrixXd right = Eigen::MatrixXd::Random(n, 3);
    Eigen::MatrixXd x = right;
    CyclicBand(open).solve(x);
    EXPECT_LT((full * x - right).norm(), 1e-13 * right.norm()) << n;
  }
}

}  // namespace
}  // namespace wale
