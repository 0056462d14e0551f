/// The routines of LAPACK that are used here, with Eigen's matrices in place of pointers and sizes.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <vector>

extern "C" {
void dpbtrf_(const char* uplo, const int* n, const int* kd, double* ab, const int* ldab, int* info, std::size_t);
void dpbtrs_(const char* uplo, const int* n, const int* kd, const int* nrhs, const double* ab, const int* ldab,
             double* b, const int* ldb, int* info, std::size_t);
void dgbtrf_(const int* m, const int* n, const int* kl, const int* ku, double* ab, const int* ldab, int* ipiv,
             int* info);
void dgbtrs_(const char* trans, const int* n, const int* kl, const int* ku, const int* nrhs, const double* ab,
             const int* ldab, const int* ipiv, double* b, const int* ldb, int* info, std::size_t);
void dgbsv_(const int* n, const int* kl, const int* ku, const int* nrhs, double* ab, const int* ldab, int* ipiv,
            double* b, const int* ldb, int* info);
void dpotrf_(const char* uplo, const int* n, double* a, const int* lda, int* info, std::size_t);
void dlauum_(const char* uplo, const int* n, double* a, const int* lda, int* info, std::size_t);
}

namespace wale::lapack {

/// Every function returns LAPACK's info: 0 for success, i > 0 where the i-th pivot (or leading minor) failed.
/// A band matrix is stored by diagonals, one column a column of the matrix. Lower symmetric: element (i, j) is
/// ab(i - j, j) and ab has 1 + subdiagonals rows. General: element (i, j) is ab(lower + upper + i - j, j), and ab
/// has 2 lower + upper + 1 rows, of which the first `lower` are LAPACK's to fill.

/// Cholesky factor of a symmetric positive definite band matrix, in place.
inline int dpbtrf(Eigen::MatrixXd& ab) {
  const int n = static_cast<int>(ab.cols()), ldab = static_cast<int>(ab.rows()), kd = ldab - 1;
  int info = 0;
  dpbtrf_("L", &n, &kd, ab.data(), &ldab, &info, 1);
  return info;
}

/// b := A⁻¹ b, with the factor of dpbtrf; one right-hand side a column.
inline int dpbtrs(const Eigen::MatrixXd& factor, Eigen::MatrixXd& b) {
  const int n = static_cast<int>(factor.cols()), ldab = static_cast<int>(factor.rows()), kd = ldab - 1;
  const int nrhs = static_cast<int>(b.cols()), ldb = static_cast<int>(b.rows());
  int info = 0;
  dpbtrs_("L", &n, &kd, &nrhs, factor.data(), &ldab, b.data(), &ldb, &info, 1);
  return info;
}

/// LU factors of a square general band matrix, in place, with the row exchanges in `pivots`.
inline int dgbtrf(int lower, int upper, Eigen::MatrixXd& ab, std::vector<int>& pivots) {
  const int n = static_cast<int>(ab.cols()), ldab = static_cast<int>(ab.rows());
  int info = 0;
  pivots.resize(static_cast<std::size_t>(n));
  dgbtrf_(&n, &n, &lower, &upper, ab.data(), &ldab, pivots.data(), &info);
  return info;
}

/// b := A⁻¹ b, with the factors of dgbtrf; one right-hand side a column.
inline int dgbtrs(int lower, int upper, const Eigen::MatrixXd& ab, const std::vector<int>& pivots, Eigen::MatrixXd& b) {
  const int n = static_cast<int>(ab.cols()), ldab = static_cast<int>(ab.rows());
  const int nrhs = static_cast<int>(b.cols()), ldb = static_cast<int>(b.rows());
  int info = 0;
  dgbtrs_("N", &n, &lower, &upper, &nrhs, ab.data(), &ldab, pivots.data(), b.data(), &ldb, &info, 1);
  return info;
}

/// b := A⁻¹ b in one call; `ab` is left as its LU factors.
inline int dgbsv(int lower, int upper, Eigen::MatrixXd& ab, Eigen::MatrixXd& b) {
  const int n = static_cast<int>(ab.cols()), ldab = static_cast<int>(ab.rows());
  const int nrhs = static_cast<int>(b.cols()), ldb = static_cast<int>(b.rows());
  int info = 0;
  std::vector<int> pivots(static_cast<std::size_t>(n));
  dgbsv_(&n, &lower, &upper, &nrhs, ab.data(), &ldab, pivots.data(), b.data(), &ldb, &info);
  return info;
}

/// Cholesky factor U of the symmetric positive definite matrix UᵀU in an upper triangle, in place.
inline int dpotrf(Eigen::MatrixXd& upper) {
  const int n = static_cast<int>(upper.cols()), lda = std::max(1, n);
  int info = 0;
  dpotrf_("U", &n, upper.data(), &lda, &info, 1);
  return info;
}

/// The upper triangle of U Uᵀ from an upper triangle U, in place.
inline int dlauum(Eigen::MatrixXd& upper) {
  const int n = static_cast<int>(upper.cols()), lda = std::max(1, n);
  int info = 0;
  dlauum_("U", &n, upper.data(), &lda, &info, 1);
  return info;
}

}  // namespace wale::lapack
