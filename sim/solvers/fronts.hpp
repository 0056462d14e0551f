/// The numeric Cholesky factorization of a part of a matrix.
#pragma once

#include "sim/solvers/front_sequence.hpp"
#include "sim/solvers/lower_triangle.hpp"
#include "sim/solvers/panels.hpp"

namespace wale {

/// Multifrontal (Duff & Reid 1983): a supernode's columns and what all below it leave of its rows make a small dense
/// matrix, in double precision; its columns are kept as Panels has them, and what it leaves waits for its parent only.
/// So no more than a small share of the factor is ever there in double precision. Factors the part of K + shift I.
/// False if that is not positive definite. Adds -C A⁻¹ Cᵀ, which the border loses to the part, to `border`. Throws
/// std::bad_alloc.
[[nodiscard]] bool factor_by_fronts(const Stiffness& K, double shift, const UsedBlocks& used,
                                    const Supernodes& supernodes, const FrontSequence& sequence, Panels& factor,
                                    LowerTriangle& border);

}  // namespace wale
