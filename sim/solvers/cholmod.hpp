/// CHOLMOD (SuiteSparse; Chen, Davis, Hager & Rajamanickam 2008) on one thread, with owners for what it allocates.
#pragma once

#include <cholmod.h>
#include <omp.h>

#include <memory>
#include <new>
#include <vector>

extern "C" void openblas_set_num_threads(int);

namespace wale::cholmod {

/// Parallel regions of the calling thread run on that thread alone while it lives. CHOLMOD 3 asks for four threads for
/// every dense block, whatever omp_set_num_threads() says, and they cost more than a block of a swatch is worth.
class OneThread {
 public:
  OneThread() { omp_set_max_active_levels(0); }
  ~OneThread() { omp_set_max_active_levels(before_); }
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  int before_ = omp_get_max_active_levels();
};

struct FreeFactor {
  cholmod_common* common;
  void operator()(cholmod_factor* factor) const { cholmod_free_factor(&factor, common); }
};
using Factor = std::unique_ptr<cholmod_factor, FreeFactor>;

/// Settings and workspace: one ordering to try, no text printed, BLAS on one thread. Must outlive its factors.
class Common {
 public:
  Common() {
    openblas_set_num_threads(1);
    cholmod_start(&common_);
    common_.print = 0;
    common_.nmethods = 1;
  }
  ~Common() { cholmod_finish(&common_); }
  Common(const Common&) = delete;
  Common& operator=(const Common&) = delete;

  cholmod_common* operator->() { return &common_; }
  cholmod_common* get() { return &common_; }

  /// The symbolic factor. Throws std::bad_alloc.
  Factor analyse(cholmod_sparse& matrix) {
    Factor factor(cholmod_analyze(&matrix, &common_), FreeFactor{&common_});
    if (!factor) throw std::bad_alloc();
    return factor;
  }

 private:
  cholmod_common common_;
};

/// A symmetric matrix of which CHOLMOD reads the lower triangle; only its pattern if `values` is null.
inline cholmod_sparse lower_triangle(std::vector<int>& starts, std::vector<int>& rows, std::vector<double>* values) {
  rows.reserve(1);  // CHOLMOD takes no null for an array, not even for one without elements
  if (values) values->reserve(1);
  cholmod_sparse a{};
  a.nrow = a.ncol = starts.size() - 1;
  a.nzmax = rows.size();
  a.p = starts.data();
  a.i = rows.data();
  a.x = values ? values->data() : nullptr;
  a.stype = -1;
  a.itype = CHOLMOD_INT;
  a.xtype = values ? CHOLMOD_REAL : CHOLMOD_PATTERN;
  a.dtype = CHOLMOD_DOUBLE;
  a.sorted = 1;
  a.packed = 1;
  return a;
}

/// The order in which CHOLMOD eliminates a pattern by the method `ordering`, and then branch by branch. Throws
/// std::bad_alloc.
inline std::vector<int> order_of(cholmod_sparse pattern, int ordering) {
  Common common;
  common->supernodal = CHOLMOD_SIMPLICIAL;  // only the order is wanted
  common->method[0].ordering = ordering;
  const Factor factor = common.analyse(pattern);
  const auto* order = static_cast<const int*>(factor->Perm);
  return {order, order + pattern.nrow};
}

}  // namespace wale::cholmod
