/// Where the mid-surface of a periodic fabric that curls is.
#pragma once

#include "sim/image.hpp"

namespace wale {

/// The mean height of the yarn's control points over the surface that the periods and the curvature are those of.
/// Further from the axis the same fabric has a longer wale period and less curvature, so that these say something only
/// while it is 0.
class MidSurface {
 public:
  /// `weights`: how much each column of State::q counts; those of the periods do not, nor should those that follow
  /// others.
  MidSurface(const PeriodicCell&, Eigen::VectorXd weights);

  /// m, of the columns of State::q.
  double height(const Points& q) const;
  /// Derivative by the columns of State::q.
  Points slope(const Points& q) const;
  /// Moves the fabric towards its axis, or from it, to where the height is 0.
  void settle(Points& q) const;

 private:
  PeriodicCell cell_;
  Eigen::VectorXd weights_;  // their sum is 1
};

}  // namespace wale
