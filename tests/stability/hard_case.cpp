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

const char* name_of(SolverKind kind) {
  switch (kind) {
    case SolverKind::runge_kutta:
      return "runge_kutta";
    case SolverKind::implicit:
      return "implicit";
    case SolverKind::quasi_static:
      return "quasi_static";
  }
  return "";
}

const char* name_of(ContactLaw law) {
  switch (law) {
    case ContactLaw::barrier:
      return "barrier";
    case ContactLaw::quadratic:
      return "quadratic";
    case ContactLaw::core_shell:
      return "core_shell";
  }
  return "";
}

}  // namespace wale::stability
