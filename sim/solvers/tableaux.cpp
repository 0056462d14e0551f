#include "sim/solvers/tableaux.hpp"

namespace wale {

const Tableau& classic43() {
  static const Tableau table{
      .name = "classic 4(3)",
      .order = 4,
      .error_order = 3,
      .c = {0, 1.0 / 3, 2.0 / 3, 1, 1},
      .a = {{}, {1.0 / 3}, {-1.0 / 3, 1}, {1, -1, 1}, {1.0 / 8, 3.0 / 8, 3.0 / 8, 1.0 / 8}},
      .error = {1.0 / 24, -1.0 / 8, 1.0 / 8, 1.0 / 8, -1.0 / 6},
  };
  return table;
}

}  // namespace wale
