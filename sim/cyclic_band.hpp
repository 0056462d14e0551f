/// The matrix of a closed yarn: banded, but for its corners.
#pragma once

#include <Eigen/Core>

namespace wale {

/// A symmetric positive definite matrix of n unknowns of which the last are neighbours of the first, factored. The last
/// three are eliminated last: what they leave between the others is a band (a Schur complement, Golub & Van Loan 4.3).
class CyclicBand {
 public:
  /// From the matrix of n + 3 unknowns of which the last three are the first three again, in LAPACK's lower band
  /// storage with 3 subdiagonals, n > 3. Throws std::invalid_argument if it is not positive definite.
  explicit CyclicBand(const Eigen::MatrixXd& open);
  /// b := A⁻¹ b; n rows, one right-hand side a column.
  void solve(Eigen::MatrixXd& b) const;

 private:
  Eigen::MatrixXd band_;                // factor of all but the last three
  Eigen::Matrix<double, 3, -1> mixed_;  // between the last three and the others
  Eigen::MatrixXd lifted_;              // band⁻¹ mixedᵀ
  Eigen::Matrix3d last_;                // inverse of the Schur complement
};

}  // namespace wale
