/// The patch of stockinette that public codes for elastic yarn were timed on, made as they were given it.
#pragma once

#include "sim/fabric.hpp"

namespace wale::peers {

/// `courses` rows of `wales` stitches, one yarn a row with both ends free: Ding et al. 2023, Eq. (4), with
/// λ = (1.25, 2.7, 0.8) mm, rows 3.6 mm apart, yarn of radius 0.524 mm.
struct Patch {
  int wales = 10, courses = 10;
  int segments_per_stitch = 16;  ///< at least 8
  double shrinkage = 0.95;       ///< rest lengths when tightened, over those as laid
};

/// Stretch and bend with EA = 79 MPa π r² and EI = 0.249 MPa π r⁴/4; contact of 1e3 N/m by the barrier law.
Material patch_yarn();

Fabric lay(const Patch&);

/// The box around all yarn axes, m: along the courses, along the wales, through the fabric.
Vec3 extent(const Fabric&, const Points& q);

/// The furthest that a row's axis is from Eq. (4), shrunk, and moved as the row has moved, m: so lies yarn that
/// remembers how it was laid, where no row presses another. Rows that clear each other may shift without force, which
/// changes the box around all.
double off_shape(const Patch&, const Fabric&, const Points& q);

}  // namespace wale::peers
