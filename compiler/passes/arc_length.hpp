/// Arc length along a yarn's curve, and the point at a given arc length.
#pragma once

#include <vector>

#include "compiler/curves.hpp"

namespace wale {

/// Gauss quadrature piece by piece; refers to the curve, which must outlive it.
class ArcLength {
 public:
  explicit ArcLength(const YarnCurve&);
  double total() const { return start_.back(); }
  double length_of(std::size_t piece) const { return start_[piece + 1] - start_[piece]; }
  /// The piece that holds the point at arc length `s`, m; s is clamped to [0, total()].
  std::size_t piece_at(double s) const;
  /// The point at arc length `s`, to 1e-13 of the total, by Newton's method or else Ridders' bracketed root-finder.
  CurvePiece::Point at(double s) const;

 private:
  double up_to(std::size_t piece, double u) const;  // arc length from the piece's start, m

  const YarnCurve& curve_;
  std::vector<double> start_;               // of each piece, and the total
  std::vector<std::vector<double>> knots_;  // arc length at even steps of u, by piece
};

}  // namespace wale
