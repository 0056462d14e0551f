#include "sim/solvers/cholesky.hpp"

#include "sim/solvers/cholmod.hpp"
#include "sim/solvers/ordered_matrix.hpp"

namespace wale {

struct Cholesky::Work {
  cholmod::Common common;
  OrderedMatrix matrix;
  cholmod::Factor factor{nullptr, {common.get()}};
  Eigen::VectorXd right;                                          // in the order of elimination
  cholmod_dense *solution = nullptr, *y = nullptr, *e = nullptr;  // made by cholmod_solve2, and used again

  Work() {
    common->supernodal = CHOLMOD_SUPERNODAL;
    // The points lie in their order already, so CHOLMOD reads the matrix where it is instead of permuting a copy.
    common->method[0].ordering = CHOLMOD_NATURAL;
    common->postorder = 0;
  }
  ~Work() {
    for (cholmod_dense* dense : {solution, y, e}) cholmod_free_dense(&dense, common.get());
  }
};

Cholesky::Cholesky() : work_(std::make_unique<Work>()) {}
Cholesky::~Cholesky() = default;

void Cholesky::forget() { work_ = std::make_unique<Work>(); }

bool Cholesky::factor(const Stiffness& K, double shift) {
  auto& [common, matrix, factor, right, solution, y, e] = *work_;
  const bool is_new_pattern = matrix.update(K);
  cholmod_sparse view = matrix.view();
  const cholmod::OneThread guard;
  if (is_new_pattern) factor = common.analyse(view);
  double beta[2] = {shift, 0};
  cholmod_factorize_p(&view, beta, nullptr, 0, factor.get(), common.get());
  if (common->status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
  return common->status == CHOLMOD_OK && factor->minor == factor->n;
}

void Cholesky::solve(Eigen::VectorXd& x) const {
  auto& [common, matrix, factor, right, solution, y, e] = *work_;
  const std::vector<int>& order = matrix.order();
  right.resize(x.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    right.segment<3>(3 * static_cast<Eigen::Index>(k)) = x.segment<3>(3 * order[k]);
  cholmod_dense b{};
  b.nrow = b.d = b.nzmax = static_cast<std::size_t>(x.size());
  b.ncol = 1;
  b.x = right.data();
  b.xtype = CHOLMOD_REAL;
  b.dtype = CHOLMOD_DOUBLE;
  const cholmod::OneThread guard;
  if (!cholmod_solve2(CHOLMOD_A, factor.get(), &b, nullptr, &solution, nullptr, &y, &e, common.get()))
    throw std::bad_alloc();
  const Eigen::Map<const Eigen::VectorXd> found(static_cast<const double*>(solution->x), x.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    x.segment<3>(3 * order[k]) = found.segment<3>(3 * static_cast<Eigen::Index>(k));
}

}  // namespace wale
