/// What SUNDIALS is given: vectors that look into Eigen's memory, and handles that free what they hold.
#pragma once

#include <nvector/nvector_serial.h>
#include <sundials/sundials_linearsolver.h>

#include <Eigen/Core>
#include <memory>
#include <stdexcept>
#include <sundials/sundials_context.hpp>

namespace wale::peers {

using Vector = std::unique_ptr<std::remove_pointer_t<N_Vector>, decltype(&N_VDestroy)>;
using LinearSolver = std::unique_ptr<std::remove_pointer_t<SUNLinearSolver>, decltype(&SUNLinSolFree)>;

/// A vector over the memory of `x`, which must outlive it and keep its size.
inline Vector wrap(Eigen::VectorXd& x, SUNContext context) {
  return {N_VMake_Serial(x.size(), x.data(), context), &N_VDestroy};
}

inline Eigen::Map<Eigen::VectorXd> view(N_Vector x) { return {N_VGetArrayPointer(x), N_VGetLength_Serial(x)}; }

/// SUNDIALS says by negative numbers that it was misused.
inline void check(int flag) {
  if (flag < 0) throw std::runtime_error("SUNDIALS refused a setting");
}

}  // namespace wale::peers
