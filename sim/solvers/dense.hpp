/// The four dense routines of BLAS and LAPACK that a sparse Cholesky factor is made of, column-major.
#pragma once

#include <cstddef>

extern "C" {
void dpotrf_(const char*, const int*, double*, const int*, int*, std::size_t);
void dtrsm_(const char*, const char*, const char*, const char*, const int*, const int*, const double*, const double*,
            const int*, double*, const int*, std::size_t, std::size_t, std::size_t, std::size_t);
void dsyrk_(const char*, const char*, const int*, const int*, const double*, const double*, const int*, const double*,
            double*, const int*, std::size_t, std::size_t);
void dgemm_(const char*, const char*, const int*, const int*, const int*, const double*, const double*, const int*,
            const double*, const int*, const double*, double*, const int*, std::size_t, std::size_t);
}

namespace wale::dense {

/// A = L Lᵀ on the lower triangle of n x n. False if A is not positive definite.
inline bool factor(int n, double* a, int lda) {
  int info = 0;
  dpotrf_("L", &n, a, &lda, &info, 1);
  return info == 0;
}

/// B := B L⁻ᵀ, B of m x n.
inline void divide(int m, int n, const double* l, int ldl, double* b, int ldb) {
  const double one = 1;
  dtrsm_("R", "L", "T", "N", &m, &n, &one, l, &ldl, b, &ldb, 1, 1, 1, 1);
}

/// The lower triangle of C -= A Aᵀ, C of n x n, A of n x k.
inline void subtract_square(int n, int k, const double* a, int lda, double* c, int ldc) {
  const double one = 1, minus = -1;
  dsyrk_("L", "N", &n, &k, &minus, a, &lda, &one, c, &ldc, 1, 1);
}

/// C -= A Bᵀ, C of m x n, A of m x k.
inline void subtract_product(int m, int n, int k, const double* a, int lda, const double* b, int ldb, double* c,
                             int ldc) {
  const double one = 1, minus = -1;
  dgemm_("N", "T", &m, &n, &k, &minus, a, &lda, b, &ldb, &one, c, &ldc, 1, 1);
}

}  // namespace wale::dense
