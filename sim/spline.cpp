#include "sim/spline.hpp"

namespace wale {

std::span<const GaussNode> gauss(int count) {
  // Abramowitz & Stegun, table 25.4, mapped from [-1, 1] to [0, 1].
  static constexpr GaussNode one[] = {{0.5, 1}};
  static constexpr GaussNode two[] = {{0.21132486540518711775, 0.5}, {0.78867513459481288225, 0.5}};
  static constexpr GaussNode three[] = {{0.11270166537925831148, 0.27777777777777777778},
                                        {0.5, 0.44444444444444444444},
                                        {0.88729833462074168852, 0.27777777777777777778}};
  static constexpr GaussNode four[] = {{0.06943184420297371239, 0.17392742256872692869},
                                       {0.33000947820757186760, 0.32607257743127307131},
                                       {0.66999052179242813240, 0.32607257743127307131},
                                       {0.93056815579702628761, 0.17392742256872692869}};
  static constexpr GaussNode five[] = {{0.04691007703066800360, 0.11846344252809454376},
                                       {0.23076534494715845448, 0.23931433524968323402},
                                       {0.5, 0.28444444444444444444},
                                       {0.76923465505284154552, 0.23931433524968323402},
                                       {0.95308992296933199640, 0.11846344252809454376}};
  static constexpr std::span<const GaussNode> rules[] = {one, two, three, four, five};
  assert(count >= 1 && count <= 5);
  return rules[count - 1];
}

}  // namespace wale
