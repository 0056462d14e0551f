/// The columns of a Cholesky factor in single precision, and solves with them.
#pragma once

#include <memory>

#include "sim/solvers/supernodes.hpp"

namespace wale {

/// Of (A Cᵀ; C B), a part and its border, the columns (L; M) with L Lᵀ = A, M Lᵀ = C. Vectors are in double precision,
/// by coordinates at the places of the supernodes, and so are all sums. Rounding the factor leaves it a factor of a
/// positive definite matrix, and L⁻¹ L̃ is as near to the identity as the single precision times the root of the
/// condition number. (A matrix that is rounded is off by the condition number itself.)
class Panels {
 public:
  /// `supernodes` must outlive it. Throws std::bad_alloc.
  explicit Panels(const Supernodes& supernodes);

  /// How many values the columns have.
  std::size_t values() const { return starts_.back(); }
  /// Takes the columns of a supernode: 3 height x 3 width, zero above the diagonal.
  void keep(int supernode, const Eigen::Ref<const Eigen::MatrixXd>& columns);

  /// (x; border) := (L⁻¹ x; border - M L⁻¹ x).
  void forward(Eigen::VectorXd& x) const;
  /// x := L⁻ᵀ (x - Mᵀ border); the border stays.
  void backward(Eigen::VectorXd& x) const;

 private:
  static constexpr int widest = 32;  // points

  /// Some columns of a supernode, from the first one's diagonal down: what is above it takes no room.
  struct Panel {
    int place = 0;   // of its first column
    int width = 0;   // points
    int height = 0;  // points
    const int* rows = nullptr;
  };

  const float* values_of(std::size_t panel) const { return values_.get() + starts_[panel]; }

  std::vector<Panel> panels_;
  std::vector<std::size_t> starts_{0};  // by panel: where its values start, by columns; one more at the end
  std::vector<std::size_t> first_;      // by supernode: its first panel; one more at the end
  std::unique_ptr<float[]> values_;     // on the diagonal the reciprocals
  std::size_t tallest_ = 0;             // coordinates
};

}  // namespace wale
