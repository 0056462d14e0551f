/// How often the yarns of a tube go around it.
#pragma once

#include "sim/fabric.hpp"

namespace wale {

struct Turns {
  double count =
      0;  ///< of all yarns together, about an axis through the middle of the fabric; right-handed are positive
  double extent = 0;  ///< how far the yarns reach along that axis, m
};

/// `axis` has length 1.
Turns turns_about(const Fabric&, const Points& q, const Vec3& axis);

}  // namespace wale
