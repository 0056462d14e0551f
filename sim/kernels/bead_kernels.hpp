/// What the kernels of beads are given. Beads lie in rows, one a segment: all x, then all y, then all z, each `stride`
/// numbers, a multiple of four; behind a segment's last bead x is so far away that nothing touches.
#pragma once

#include <cstddef>
#include <cstdint>

namespace wale {

struct Material;

/// Beads a row is a multiple of.
inline constexpr int row_step = 4;
/// How far kernels read beyond the last pair.
inline constexpr int pair_padding = 12;
/// x of a place in a row where no bead is, m; its square is still finite.
inline constexpr double nowhere = 1e100;

/// The rows of all segments.
struct BeadRows {
  int stride = 0;                       ///< numbers a coordinate
  const double* at = nullptr;           ///< where beads are, m
  const double* arc = nullptr;          ///< `stride` numbers a segment: how far along its yarn a bead is, m
  const std::int32_t* count = nullptr;  ///< beads, by segment
  const double* row(int segment) const { return row(segment, at); }
  /// The same of other beads in as many rows.
  const double* row(int segment, const double* of) const { return of + 3 * static_cast<long>(stride) * segment; }
};

/// Puts beads where the spline is.
struct BeadLocating {
  BeadRows rows;
  const double* q = nullptr;                  ///< control points
  const std::int32_t* first_point = nullptr;  ///< by segment
  /// Five arrays of `stride` numbers for each number of beads: what a bead's four control points weigh, and what is
  /// added to x.
  const double* weights = nullptr;
  const double* before = nullptr;  ///< rows to compare with, or null
  double most_moved = 0;           ///< m²
  double* at = nullptr;            ///< the rows to fill
};

/// Measures pairs of segments with one image of each other.
struct BeadMeasuring {
  BeadRows rows;
  const double* image = nullptr;             ///< where the beads of the image are before they are displaced, as rows.at
  const double* displacement = nullptr;      ///< of the image from there: x, y, z, m
  const std::int32_t* first_pair = nullptr;  ///< by segment a, and one more
  const std::int32_t* partner = nullptr;     ///< by pair: segment b; and `pair_padding` more of any segments
  const std::uint8_t* near_along = nullptr;  ///< by pair: whether beads of it may be screened
  const double* arc_on = nullptr;            ///< by pair: what is added to the arc of b then, m
  const std::int32_t* material = nullptr;    ///< by segment
  int materials = 0;
  const double* inverse_square = nullptr;    ///< 1/d² for each two materials, 1/m²
  const double* screening_length = nullptr;  ///< for each two materials, m
  double* squared = nullptr;                 ///< by pair, to fill: the least squared distance of two beads, m²
};

/// Two segments that touch.
struct BeadContact {
  std::size_t pair = 0;  ///< of Beads::pairs()
  int a = 0, b = 0;
  int image = 0;                ///< of b, of Beads::images()
  double weight = 0;            ///< l_a l_b / (n_a n_b), m² (Ding et al. 2023, Eqs. 17-21 as corrected)
  double diameter = 0;          ///< of this contact, m
  double screening_length = 0;  ///< beads nearer than that along their yarn do not touch, m; 0 on different yarns
  double arc_on = 0;            ///< what is added to the arc of b, m
};

/// Pushes the beads of a range of segments off those of others.
struct BeadPushing {
  BeadRows rows;
  const Material* materials = nullptr;
  const std::int32_t* material = nullptr;  ///< by segment
  const double* const* images = nullptr;   ///< by image: where its beads are before they are displaced, as rows.at
  const double* displacements = nullptr;   ///< by image: x, y, z, m
  const BeadContact* contacts = nullptr;   ///< those of one a together
  int count = 0;
  int first = 0, last = 0;     ///< the range; it holds every a
  double* push = nullptr;      ///< rows of the range, N: added to
  double* outgoing = nullptr;  ///< a row for each contact that leaves(), N: set
};

/// Carries what pushes beads to the control points.
struct BeadSpreading {
  int stride = 0;
  const std::int32_t* count = nullptr;        ///< beads, by segment
  const std::int32_t* first_point = nullptr;  ///< by segment
  const double* weights =
      nullptr;  ///< 4 numbers a bead, 4 `stride` for each number of beads: its control points' weights
  const std::uint8_t* touched = nullptr;  ///< of the range: whether its row is not all zero
  const double* push = nullptr;           ///< rows of the range, N
  int origin = 0;                         ///< the control point where `force` begins
  long force_stride = 0;
  double* force = nullptr;  ///< all x, then all y, then all z, `force_stride` apart, N: added to
};

struct BeadKernels {
  /// Segments first ... last - 1; false if a bead moved further than allowed, or if a number is not finite.
  bool (*locate)(const BeadLocating&, int first, int last);
  /// The pairs of segments a = first ... last - 1; the least squared distance over the squared diameter.
  double (*measure)(const BeadMeasuring&, int first, int last);
  /// The energy, J.
  double (*push)(const BeadPushing&);
  /// The rows of segments first ... last - 1.
  void (*spread)(const BeadSpreading&, int first, int last);
};

}  // namespace wale
