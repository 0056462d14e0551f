/// What the kernel of a law along the yarn is given: some adjacent segments of one yarn.
#pragma once

namespace wale {

/// Most segments of a block; all that a kernel works on then lies in the first cache.
inline constexpr int block_length = 64;
/// Kernels read, and never use, so many numbers beyond those of a block's segments.
inline constexpr int block_padding = 8;

/// A node of a quadrature rule, and what the four control points weigh there: value, first and second derivative by s.
struct NodeWeights {
  double weight = 0;
  double value[4] = {}, first[4] = {}, second[4] = {};
};

/// Arrays by segment hold `count` numbers and `block_padding` more.
struct AlongBlock {
  int count = 0;                      ///< segments, 1 ... block_length
  const double* points = nullptr;     ///< control points q, or velocities v for a law that depends on them: x, y, z of
                                      ///< the first, and so on; count + 3 of them
  double* force = nullptr;            ///< the same, N; may be null
  const double* l = nullptr;          ///< rest lengths now, m
  const double* l0 = nullptr;         ///< rest lengths as laid, m
  const double* constant = nullptr;   ///< what the law asked of the material
  const double* reference = nullptr;  ///< null, or three arrays (x, y, z) a node, one after the other
  long reference_stride = 0;          ///< from one of these arrays to the next
  const NodeWeights* nodes = nullptr;
  int node_count = 0;
  double energy = 0, dissipation = 0;  ///< the kernel's answer, J and W
};

/// Adds the law's forces to those of the control points, and sets energy and dissipation.
template <class L>
using AlongKernel = void (*)(const L&, AlongBlock&);

}  // namespace wale
