#include "tests/stability/hard_case.hpp"

#include <algorithm>
#include <stdexcept>

namespace wale::stability {

const std::vector<HardCase>& hard_cases() {
  static const std::vector<HardCase> all = [] {
    std::vector<HardCase> cases;
    for (auto some : {cases_of_yarns(), cases_of_knots(), cases_of_fabrics()})
      cases.insert(cases.end(), some.begin(), some.end());
    return cases;
  }();
  return all;
}

const HardCase& hard_case(const std::string& name) {
  const auto& all = hard_cases();
  const auto found = std::find_if(all.begin(), all.end(), [&](const HardCase& one) { return one.name == name; });
  if (found == all.end()) throw std::invalid_argument("no hard case is called " + name);
  return *found;
}

std::string name_of(SolverKind kind) {
  constexpr const char* names[] = {"runge_kutta", "implicit", "quasi_static"};
  return names[static_cast<std::size_t>(kind)];
}

std::string name_of(ContactLaw law) { return std::string(contact_law_names[static_cast<std::size_t>(law)]); }

}  // namespace wale::stability
