#include <kinsol/kinsol.h>
#include <sunlinsol/sunlinsol_spgmr.h>

#include <cmath>

#include "bench/peers/balance.hpp"
#include "bench/peers/methods.hpp"
#include "bench/peers/stopwatch.hpp"
#include "bench/peers/vectors.hpp"

namespace wale::peers {
namespace {

// As sim/solvers/equilibrium.cpp, of the diameter: how far a point may move at once, and how far one would that nothing
// but the shift holds.
constexpr double furthest_move = 0.3, reach_when_free = 1.5;
constexpr int most_inner = 60, most_iterations = 200;
constexpr double smallest_step = 1.0 / 8;  // of the first

struct System {
  Balance balance;
  double diameter = 0;  // m
};

System& of(void* system) { return *static_cast<System*>(system); }

int residual(N_Vector x, N_Vector out, void* system) { return of(system).balance.force(view(x), view(out)) ? 0 : 1; }
int set_up(N_Vector x, N_Vector, N_Vector force, N_Vector, void* system) {
  Balance& balance = of(system).balance;
  balance.assemble(view(x));
  return balance.factor(Balance::residual(view(force)) / (reach_when_free * of(system).diameter)) ? 0 : 1;
}
// KINSOL asks for the derivative of the force: minus the stiffness.
int precondition(N_Vector, N_Vector, N_Vector, N_Vector, N_Vector v, void* system) {
  of(system).balance.solve(view(v));
  view(v) = -view(v);
  return 0;
}
int multiply(N_Vector v, N_Vector out, N_Vector, booleantype*, void* system) {
  of(system).balance.multiply(view(v), view(out));
  view(out) = -view(out);
  return 0;
}

struct Free {
  void operator()(void* memory) const { KINFree(&memory); }
};

}  // namespace

Answer rest_by_kinsol(World& world, const State& start, double until, const Rest& rest) {
  const Stopwatch watch;
  const sundials::Context context;
  const Material& yarn = world.fabric().materials.front();
  System system{Balance(world, start), yarn.diameter};
  Balance& balance = system.balance;
  Eigen::VectorXd x = Eigen::VectorXd::Zero(balance.size());
  Eigen::VectorXd by_diameter = Eigen::VectorXd::Constant(x.size(), 1 / yarn.diameter);
  Eigen::VectorXd by_force = Eigen::VectorXd::Constant(x.size(), yarn.diameter * yarn.diameter / yarn.bending_rigidity);
  const Vector vector = wrap(x, context), u_scale = wrap(by_diameter, context), f_scale = wrap(by_force, context);
  const LinearSolver solver(SUNLinSol_SPGMR(vector.get(), SUN_PREC_RIGHT, most_inner, context), &SUNLinSolFree);
  const std::unique_ptr<void, Free> memory(KINCreate(context));
  check(KINInit(memory.get(), residual, vector.get()));
  check(KINSetUserData(memory.get(), &system));
  check(KINSetLinearSolver(memory.get(), solver.get(), nullptr));
  check(KINSetPreconditioner(memory.get(), set_up, precondition));
  check(KINSetJacTimesVecFn(memory.get(), multiply));
  check(KINSetMaxSetupCalls(memory.get(), 1));
  check(KINSetNumMaxIters(memory.get(), most_iterations));
  check(KINSetFuncNormTol(memory.get(), rest.tolerance));
  check(KINSetScaledStepTol(memory.get(), 1e-12));
  check(KINSetMaxNewtonStep(memory.get(), furthest_move * std::sqrt(static_cast<double>(x.size()) / 3)));
  check(KINSetErrFile(memory.get(), nullptr));

  Answer answer;
  double t = start.t, step = (until - t) / rest.samples;
  const double least = smallest_step * step;
  while (t < until) {
    const double to = std::min(until, t + step);
    balance.load(to);
    x.setZero();
    const int flag = KINSol(memory.get(), vector.get(), KIN_LINESEARCH, u_scale.get(), f_scale.get());
    if (flag == KIN_SUCCESS || flag == KIN_INITIAL_GUESS_OK) {
      balance.settle(x);
      t = to;
      ++answer.steps;
      continue;
    }
    step = (to - t) / 2;
    if (step < least) {
      answer.failure = std::string(KINGetReturnFlagName(flag));
      break;
    }
  }
  balance.load(t);
  balance.conclude(answer, watch);
  return answer;
}

}  // namespace wale::peers
