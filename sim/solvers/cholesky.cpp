#include "sim/solvers/cholesky.hpp"

#include <cholmod.h>

#include <cstring>
#include <new>

extern "C" void openblas_set_num_threads(int);

namespace wale {

struct Cholesky::Work {
  cholmod_common common;
  cholmod_factor* factor = nullptr;
  Stiffness::Compressed matrix;
  long matrix_version = -1, analysed_version = -1;

  Work() {
    cholmod_start(&common);
    // The dense blocks of a swatch are too small to share among threads, and one thread gives the same bits always.
    openblas_set_num_threads(1);
    common.print = 0;
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.error_handler = nullptr;
  }
  ~Work() {
    if (factor) cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }

  cholmod_sparse view() {
    cholmod_sparse a{};
    a.nrow = a.ncol = matrix.start.size() - 1;
    a.nzmax = matrix.row.size();
    a.p = matrix.start.data();
    a.i = matrix.row.data();
    a.x = matrix.value.data();
    a.stype = 1;  // the upper triangle is stored
    a.itype = CHOLMOD_INT;
    a.xtype = CHOLMOD_REAL;
    a.dtype = CHOLMOD_DOUBLE;
    a.sorted = 1;
    a.packed = 1;
    return a;
  }
};

Cholesky::Cholesky() : work_(std::make_unique<Work>()) {}
Cholesky::~Cholesky() = default;

bool Cholesky::factor(const Stiffness& K, double shift) {
  K.compress(work_->matrix, work_->matrix_version);
  cholmod_sparse a = work_->view();
  if (work_->analysed_version != work_->matrix_version) {
    if (work_->factor) cholmod_free_factor(&work_->factor, &work_->common);
    work_->factor = cholmod_analyze(&a, &work_->common);
    work_->analysed_version = work_->matrix_version;
    if (!work_->factor) throw std::bad_alloc();
  }
  double beta[2] = {shift, 0};
  cholmod_factorize_p(&a, beta, nullptr, 0, work_->factor, &work_->common);
  if (work_->common.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
  return work_->common.status == CHOLMOD_OK && work_->factor->minor == work_->factor->n;
}

void Cholesky::solve(Eigen::VectorXd& x) const {
  cholmod_dense b{};
  b.nrow = b.d = b.nzmax = static_cast<std::size_t>(x.size());
  b.ncol = 1;
  b.x = x.data();
  b.xtype = CHOLMOD_REAL;
  b.dtype = CHOLMOD_DOUBLE;
  cholmod_dense* solution = cholmod_solve(CHOLMOD_A, work_->factor, &b, &work_->common);
  if (!solution) throw std::bad_alloc();
  std::memcpy(x.data(), solution->x, sizeof(double) * static_cast<std::size_t>(x.size()));
  cholmod_free_dense(&solution, &work_->common);
}

}  // namespace wale
