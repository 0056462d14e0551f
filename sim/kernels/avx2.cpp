#include "sim/kernels/kernels_of.hpp"

namespace wale {

#if defined(__x86_64__)
namespace {
using Four = std::experimental::simd<double, std::experimental::simd_abi::deduce_t<double, 4>>;
}
constinit const Kernels avx2_kernels = kernels_of<Four, Four>;
#endif

}  // namespace wale
