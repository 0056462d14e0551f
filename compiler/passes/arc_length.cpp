#include "compiler/passes/arc_length.hpp"

#include <algorithm>
#include <cmath>

#include "sim/spline.hpp"

namespace wale {
namespace {

// A piece; blends, which have no third derivative at their ends, begin and end with a step.
constexpr int steps = 40;
constexpr int most_newton_steps = 6;  // a few do; where the yarn all but stands still the bracket is surer

double length_between(const CurvePiece& piece, double from, double to) {
  double length = 0;
  for (const GaussNode& node : gauss(5)) length += node.weight * piece.at(from + node.s * (to - from)).dy.norm();
  return length * (to - from);
}

/// The root of an increasing `f` in [low, high] (Ridders 1979).
template <class F>
double ridders(const F& f, double low, double high, double tolerance) {
  double f_low = f(low), f_high = f(high);
  if (f_low >= 0) return low;
  if (f_high <= 0) return high;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2, f_middle = f(middle);
    const double root = middle - (middle - low) * f_middle / std::sqrt(f_middle * f_middle - f_low * f_high);
    const double f_root = f(root);
    if (std::abs(f_root) <= tolerance) return root;
    for (const auto& [x, fx] : {std::pair{middle, f_middle}, std::pair{root, f_root}}) {
      if (fx < 0 && x > low) low = x, f_low = fx;
      if (fx >= 0 && x < high) high = x, f_high = fx;
    }
  }
  return (low + high) / 2;
}

}  // namespace

ArcLength::ArcLength(const YarnCurve& curve) : curve_(curve), start_{0}, knots_(curve.pieces.size()) {
#pragma omp parallel for schedule(static)
  for (std::size_t k = 0; k < knots_.size(); ++k) {
    std::vector<double> knots{0};
    for (int i = 0; i < steps; ++i)
      knots.push_back(knots.back() + length_between(curve.pieces[k], i / double(steps), (i + 1) / double(steps)));
    knots_[k] = std::move(knots);
  }
  for (const std::vector<double>& knots : knots_) start_.push_back(start_.back() + knots.back());
}

std::size_t ArcLength::piece_at(double s) const {
  const auto after = std::upper_bound(start_.begin(), start_.end(), s);
  const auto index = std::distance(start_.begin(), after) - 1;
  return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(index, 0, static_cast<std::ptrdiff_t>(knots_.size()) - 1));
}

double ArcLength::up_to(std::size_t piece, double u) const {
  const int step = std::clamp(static_cast<int>(u * steps), 0, steps - 1);
  return knots_[piece][static_cast<std::size_t>(step)] + length_between(curve_.pieces[piece], step / double(steps), u);
}

CurvePiece::Point ArcLength::at(double s) const {
  const std::size_t piece = piece_at(s);
  const auto& knots = knots_[piece];
  const double along = std::clamp(s - start_[piece], 0.0, knots.back());
  const auto after = std::upper_bound(knots.begin() + 1, knots.end() - 1, along);
  const double high = double(std::distance(knots.begin(), after)) / steps, low = high - 1.0 / steps;
  const double tolerance = 1e-13 * total();
  double u = low + (along - *(after - 1)) / (*after - *(after - 1)) / steps;
  for (int i = 0; i < most_newton_steps; ++i) {
    const double off = up_to(piece, u) - along;
    if (std::abs(off) <= tolerance) return curve_.pieces[piece].at(u);
    u = std::clamp(u - off / curve_.pieces[piece].at(u).dy.norm(), low, high);
  }
  u = ridders([&](double x) { return up_to(piece, x) - along; }, low, high, tolerance);
  return curve_.pieces[piece].at(u);
}

}  // namespace wale
