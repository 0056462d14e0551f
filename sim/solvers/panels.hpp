/// The columns of a Cholesky factor, and solves with them.
#pragma once

#include <cstdint>
#include <variant>

#include "sim/large_pages.hpp"
#include "sim/solvers/supernodes.hpp"

namespace wale {

/// In single precision a solve reads half as much memory, and is off by 6e-8 times the root of the condition number:
/// what is rounded stays a factor of a positive definite matrix. (To round the matrix itself, or what is left of it
/// halfway, would cost the condition number.)
enum class Precision : std::uint8_t { single_, double_ };

/// Of (A Cᵀ; C B), a part and its border, the columns (L; M) with L Lᵀ = A, M Lᵀ = C. Vectors are by coordinates at the
/// places of the supernodes; they and all sums are in double precision.
class Panels {
 public:
  /// `supernodes` must outlive it. Throws std::bad_alloc.
  Panels(const Supernodes& supernodes, Precision precision);

  /// How many values the columns have.
  std::size_t values() const { return starts_.back(); }
  /// Takes the columns of a supernode: 3 height x 3 width, zero above the diagonal.
  void keep(int supernode, const Eigen::Ref<const Eigen::MatrixXd>& columns);

  /// (x; border) := (L⁻¹ x; border - M L⁻¹ x).
  void forward(Eigen::VectorXd& x) const;
  /// x := L⁻ᵀ (x - Mᵀ border); the border stays.
  void backward(Eigen::VectorXd& x) const;

 private:
  static constexpr int widest = 8;  // points: the wider, the more zeros above the diagonal

  /// Some columns of a supernode, from the first one's diagonal down: what is above it takes no room.
  struct Panel {
    int place = 0;   // of its first column
    int width = 0;   // points
    int height = 0;  // points
    const int* rows = nullptr;
  };

  template <class Value>
  void keep(int supernode, const Eigen::Ref<const Eigen::MatrixXd>& columns, Value* values) const;
  template <class Value>
  void forward(const Value* values, Eigen::VectorXd& x) const;
  template <class Value>
  void backward(const Value* values, Eigen::VectorXd& x) const;

  std::vector<Panel> panels_;
  std::vector<std::size_t> starts_{0};  // by panel: where its values start, by columns; one more at the end
  std::vector<std::size_t> first_;      // by supernode: its first panel; one more at the end
  std::variant<LargeArray<float>, LargeArray<double>> values_;  // on the diagonal the reciprocals
  std::size_t tallest_ = 0;                                     // coordinates
};

}  // namespace wale
