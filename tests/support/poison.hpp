/// An effect that makes a solver fail.
#pragma once

#include <limits>

#include "sim/effect.hpp"

namespace wale {

/// Pushes a control point with a force that is not a number from some time on.
class Poison final : public Effect {
 public:
  explicit Poison(double from, int point = 0) : from_(from), point_(point) {}
  std::string_view name() const override { return "poison"; }
  void add(const State& at, Load& out) const override {
    if (out.force && at.t >= from_) (*out.force)(0, point_) = std::numeric_limits<double>::quiet_NaN();
  }

 private:
  double from_;  // s
  int point_;
};

}  // namespace wale
