/// Matrices as those of fabrics, without a fabric.
#pragma once

#include <random>

#include "sim/stiffness.hpp"

namespace wale {

/// A chain of points that lies in rows, each tied to the row before, as yarn in a fabric.
class RandomTies {
 public:
  RandomTies(int points, int row, unsigned seed) : points_(points), row_(row), random_(seed) {}

  Stiffness matrix() {
    Stiffness K(points_);
    for (int i = 0; i < points_; ++i)
      for (const int j : {i + 1, i + 2, i + 3, i + row_, i + row_ + 1})
        if (j < points_) tie(K, i, j);
    return K;
  }

  /// Positive semidefinite: the square of a difference of two points.
  void tie(Stiffness& K, int i, int j) {
    std::uniform_real_distribution<double> number(-1, 1);
    const Mat3 any = Mat3::NullaryExpr([&] { return number(random_); }), square = any.transpose() * any;
    K.add(i, i, square);
    K.add(j, j, square);
    K.add(i, j, -square);
  }

 private:
  int points_, row_;
  std::mt19937 random_;
};

}  // namespace wale
