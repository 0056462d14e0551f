/// The routines of LAPACK and BLAS that are used here, with Eigen's matrices in place of pointers and sizes.
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
void dtrsm_(const char* side, const char* uplo, const char* trans, const char* diag, const int* m, const int* n,
            const double* alpha, const double* a, const int* lda, double* b, const int* ldb, std::size_t, std::size_t,
            std::size_t, std::size_t);
void dgemm_(const char* transa, const char* transb, const int* m, const int* n, const int* k, const double* alpha,
            const double* a, const int* lda, const double* b, const int* ldb, const double* beta, double* c,
            const int* ldc, std::size_t, std::size_t);
void dsyrk_(const char* uplo, const char* trans, const int* n, const int* k, const double* alpha, const double* a,
            const int* lda, const double* beta, double* c, const int* ldc, std::size_t, std::size_t);
}

namespace wale::lapack {

/// Every function of LAPACK returns its info: 0 for success, i > 0 where the i-th pivot (or leading minor) failed.
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

/// Cholesky factor of the symmetric positive definite matrix in a lower triangle, in place.
inline int dpotrf(Eigen::Ref<Eigen::MatrixXd> lower) {
  const int n = static_cast<int>(lower.cols()), lda = std::max(1, static_cast<int>(lower.outerStride()));
  int info = 0;
  dpotrf_("L", &n, lower.data(), &lda, &info, 1);
  return info;
}

/// b := b L⁻ᵀ with a lower triangle L.
inline void dtrsm(const Eigen::Ref<const Eigen::MatrixXd>& lower, Eigen::Ref<Eigen::MatrixXd> b) {
  const int m = static_cast<int>(b.rows()), n = static_cast<int>(b.cols());
  const int lda = std::max(1, static_cast<int>(lower.outerStride()));
  const int ldb = std::max(1, static_cast<int>(b.outerStride()));
  const double one = 1;
  dtrsm_("R", "L", "T", "N", &m, &n, &one, lower.data(), &lda, b.data(), &ldb, 1, 1, 1, 1);
}

/// c := c - a aᵀ, its lower triangle.
inline void dsyrk(const Eigen::Ref<const Eigen::MatrixXd>& a, Eigen::Ref<Eigen::MatrixXd> c) {
  const int n = static_cast<int>(a.rows()), k = static_cast<int>(a.cols());
  const int lda = std::max(1, static_cast<int>(a.outerStride()));
  const int ldc = std::max(1, static_cast<int>(c.outerStride()));
  const double minus = -1, one = 1;
  dsyrk_("L", "N", &n, &k, &minus, a.data(), &lda, &one, c.data(), &ldc, 1, 1);
}

/// c := c - a bᵀ.
inline void dgemm(const Eigen::Ref<const Eigen::MatrixXd>& a, const Eigen::Ref<const Eigen::MatrixXd>& b,
                  Eigen::Ref<Eigen::MatrixXd> c) {
  const int m = static_cast<int>(a.rows()), n = static_cast<int>(b.rows()), k = static_cast<int>(a.cols());
  const int lda = std::max(1, static_cast<int>(a.outerStride()));
  const int ldb = std::max(1, static_cast<int>(b.outerStride()));
  const int ldc = std::max(1, static_cast<int>(c.outerStride()));
  const double minus = -1, one = 1;
  dgemm_("N", "T", &m, &n, &k, &minus, a.data(), &lda, b.data(), &ldb, &one, c.data(), &ldc, 1, 1);
}

}  // namespace wale::lapack
