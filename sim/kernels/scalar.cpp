#include "sim/kernels/kernels_of.hpp"

namespace wale {

constinit const Kernels scalar_kernels = kernels_of<double, double>;

}  // namespace wale
