#include "sim/kernels/kernels_of.hpp"

namespace wale {

#if defined(__x86_64__)
namespace {
using Eight = std::experimental::simd<double, std::experimental::simd_abi::deduce_t<double, 8>>;
using Four = std::experimental::simd<double, std::experimental::simd_abi::deduce_t<double, 4>>;
}  // namespace
constinit const Kernels avx512_kernels = kernels_of<Eight, Four>;
#endif

}  // namespace wale
