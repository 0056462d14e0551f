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

/// The listed pairs of segments with one image of each other.
struct BeadPairs {
  BeadRows rows;
  const double* image = nullptr;             ///< where the beads of the image are before they are displaced, as rows.at
  const double* displacement = nullptr;      ///< of the image from there: x, y, z, m
  const std::int32_t* a = nullptr;           ///< by pair: a segment
  const std::int32_t* b = nullptr;           ///< by pair: another one; and `pair_padding` more of any segments
  const std::uint8_t* near_along = nullptr;  ///< by pair: whether beads of it may be screened
  const double* arc_on = nullptr;            ///< by pair: what is added to the arc of b then, m
  const std::int32_t* material = nullptr;    ///< by segment
  int materials = 0;
  const double* screening_length = nullptr;  ///< for each two materials: beads nearer along their yarn do not touch, m
};

struct BeadMeasuring {
  BeadPairs pairs;
  const double* inverse_square = nullptr;  ///< by pair: 1/d², 1/m²
  double* squared = nullptr;               ///< by pair, to fill: the least squared distance of two beads, m²
};

/// Pushes beads of two segments off each other, those of a in a range of segments.
struct BeadPushing {
  BeadPairs pairs;
  const double* squared = nullptr;         ///< by pair, as measured, m²
  const double* inverse_square = nullptr;  ///< by pair: 1/d² with the diameter at which beads touch, 1/m²
  const double* spacing = nullptr;         ///< by segment: between its beads, m
  const Material* materials = nullptr;
  int first = 0;                     ///< where the range begins
  int reach = 0;                     ///< whichever b lies from there on is pushed in `outgoing`; 0 if it is an image
  double* push = nullptr;            ///< rows of the range, and on to `reach`, N: added to
  std::int32_t* touching = nullptr;  ///< working space: twice as many as there are pairs
  double* outgoing = nullptr;        ///< a row for each contact with such a b, N: set
  std::int32_t* outgoing_pair = nullptr;  ///< which pair it is: set
};

struct BeadPushed {
  double energy = 0;  ///< J
  int outgoing = 0;   ///< how many rows of `outgoing` were set
};

/// Carries what pushes beads to the control points.
struct BeadSpreading {
  int stride = 0;
  const std::int32_t* count = nullptr;        ///< beads, by segment
  const std::int32_t* first_point = nullptr;  ///< by segment
  /// 4 numbers a bead, 4 `stride` for each number of beads: its control points' weights.
  const double* weights = nullptr;
  const double* push = nullptr;  ///< rows of the range, N
  int origin = 0;                ///< the control point where `force` begins
  long force_stride = 0;
  double* force = nullptr;  ///< all x, then all y, then all z, `force_stride` apart, N: set
};

struct BeadKernels {
  /// Segments first ... last - 1; false if a bead moved further than allowed, or if a number is not finite.
  bool (*locate)(const BeadLocating&, int first, int last);
  /// Pairs first ... last - 1; the least squared distance over the squared diameter.
  double (*measure)(const BeadMeasuring&, int first, int last);
  /// Pairs first ... last - 1.
  BeadPushed (*push)(const BeadPushing&, int first, int last);
  /// The rows of segments first ... last - 1.
  void (*spread)(const BeadSpreading&, int first, int last);
};

}  // namespace wale
