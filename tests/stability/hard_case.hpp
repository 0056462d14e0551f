/// A scene made harder from rung to rung, and what must hold in it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/scene.hpp"

namespace wale::stability {

/// A yarn taken as a closed curve: from its end on through these points, and back to its start.
struct Closing {
  int yarn = 0;
  Points by;  ///< 3 x n, m; far off, where no yarn comes
};

struct HardScene {
  Scene scene;
  int first_tested = 0;             ///< stages before it only prepare: with their own solver
  std::vector<Closing> closings{};  ///< whose linking numbers stay; those of a periodic fabric's courses always do
  bool tied = false;        ///< the first yarn is a knot, seen along z, that does not open: see knot_determinant()
  bool only_loses = false;  ///< nothing does work in the tested stages, so energy never grows
  bool by_itself = false;   ///< nothing acts from outside, so momentum and angular momentum stay
};

enum class SolverKind : std::uint8_t { runge_kutta, implicit, quasi_static };

/// One entry of the list of cases; adding one is adding such an entry.
struct HardCase {
  std::string name;
  std::string unit;            ///< what a rung counts: "% of d"
  std::vector<double> quick;   ///< rungs that hold, for the tests
  std::vector<double> ladder;  ///< from easy to hard, on until something breaks
  std::function<HardScene(double rung)> make;
  std::vector<SolverKind> solvers{SolverKind::runge_kutta, SolverKind::implicit, SolverKind::quasi_static};
};

/// All of them; see docs/stability.md.
const std::vector<HardCase>& hard_cases();
const HardCase& hard_case(const std::string& name);

/// The parts of that list: yarns laid by hand, knots among them, and knitted fabrics.
std::vector<HardCase> cases_of_yarns();
std::vector<HardCase> cases_of_knots();
std::vector<HardCase> cases_of_fabrics();

std::string name_of(SolverKind);
std::string name_of(ContactLaw);

}  // namespace wale::stability
