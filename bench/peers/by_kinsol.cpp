#include <kinsol/kinsol.h>
#include <sunlinsol/sunlinsol_spgmr.h>

#include <algorithm>
#include <cmath>

#include "bench/peers/methods.hpp"
#include "bench/peers/stopwatch.hpp"
#include "bench/peers/vectors.hpp"
#include "sim/solvers/cholesky.hpp"

namespace wale::peers {
namespace {

// As sim/solvers/equilibrium.cpp: how far a point may move, in diameters, and how far a free one would.
constexpr double furthest_move = 0.3, reaches_when_free = 5;
constexpr int most_inner = 60, most_iterations = 200;
constexpr double smallest_step = 1.0 / 8;  // of the first

/// force(q) = 0 at one load.
class Balance {
 public:
  Balance(World& world, State at)
      : world_(world),
        state_(std::move(at)),
        exact_(static_cast<int>(state_.q.cols())),
        convex_(static_cast<int>(state_.q.cols())),
        diameter_(world.fabric().materials.front().diameter) {}

  void load(double t) { state_.t = t; }
  bool force(N_Vector q, N_Vector out) {
    ++evaluations;
    place(q);
    Load wanted{.force = &force_};
    world_.evaluate(state_, wanted);
    view(out) = force_.reshaped();
    // Yarns that one move would bring through each other.
    return force_.allFinite() && world_.closest() > 0.1;
  }
  bool factor(N_Vector q, N_Vector force) {
    ++factorizations;
    place(q);
    Load wanted{.stiffness = &exact_, .convex = &convex_};
    world_.evaluate(state_, wanted);
    const double residual =
        std::sqrt(view(force).reshaped(3, view(force).size() / 3).colwise().squaredNorm().maxCoeff());
    return cholesky_.factor(convex_, residual / (reaches_when_free * furthest_move * diameter_));
  }
  void precondition(N_Vector v) const {
    Eigen::VectorXd x = -view(v);
    cholesky_.solve(x);
    view(v) = x;
  }
  void multiply(N_Vector v, N_Vector out) const {
    Eigen::VectorXd product;
    exact_.multiply(view(v), product);
    view(out) = -product;
  }
  const State& state(N_Vector q) {
    place(q);
    return state_;
  }

  long evaluations = 0, factorizations = 0;

 private:
  void place(N_Vector q) {
    state_.q = view(q).reshaped(3, view(q).size() / 3);
    world_.prepare(state_);
  }

  World& world_;
  State state_;
  Points force_;
  Stiffness exact_, convex_;
  Cholesky cholesky_;
  double diameter_;
};

Balance& of(void* balance) { return *static_cast<Balance*>(balance); }

int residual(N_Vector q, N_Vector out, void* balance) { return of(balance).force(q, out) ? 0 : 1; }
int set_up(N_Vector q, N_Vector, N_Vector force, N_Vector, void* balance) {
  return of(balance).factor(q, force) ? 0 : 1;
}
int precondition(N_Vector, N_Vector, N_Vector, N_Vector, N_Vector v, void* balance) {
  of(balance).precondition(v);
  return 0;
}
int multiply(N_Vector v, N_Vector out, N_Vector, booleantype*, void* balance) {
  of(balance).multiply(v, out);
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
  Balance balance(world, start);
  Eigen::VectorXd q = start.q.reshaped();
  Eigen::VectorXd by_diameter = Eigen::VectorXd::Constant(q.size(), 1 / yarn.diameter);
  Eigen::VectorXd by_force = Eigen::VectorXd::Constant(q.size(), yarn.diameter * yarn.diameter / yarn.bending_rigidity);
  const Vector vector = wrap(q, context), u_scale = wrap(by_diameter, context), f_scale = wrap(by_force, context);
  const LinearSolver solver(SUNLinSol_SPGMR(vector.get(), SUN_PREC_RIGHT, most_inner, context), &SUNLinSolFree);
  const std::unique_ptr<void, Free> memory(KINCreate(context));
  check(KINInit(memory.get(), residual, vector.get()));
  check(KINSetUserData(memory.get(), &balance));
  check(KINSetLinearSolver(memory.get(), solver.get(), nullptr));
  check(KINSetPreconditioner(memory.get(), set_up, precondition));
  check(KINSetJacTimesVecFn(memory.get(), multiply));
  check(KINSetMaxSetupCalls(memory.get(), 1));
  check(KINSetNumMaxIters(memory.get(), most_iterations));
  check(KINSetFuncNormTol(memory.get(), rest.tolerance));
  check(KINSetScaledStepTol(memory.get(), 1e-12));
  check(KINSetMaxNewtonStep(memory.get(), furthest_move * std::sqrt(static_cast<double>(q.size()) / 3)));
  check(KINSetErrFile(memory.get(), nullptr));

  Answer answer;
  double t = start.t, step = (until - t) / rest.samples;
  const double least = smallest_step * step;
  while (t < until) {
    const double to = std::min(until, t + step);
    const Eigen::VectorXd before = q;
    balance.load(to);
    const int flag = KINSol(memory.get(), vector.get(), KIN_LINESEARCH, u_scale.get(), f_scale.get());
    if (flag == KIN_SUCCESS || flag == KIN_INITIAL_GUESS_OK) {
      t = to;
      ++answer.steps;
      continue;
    }
    q = before;
    step = (to - t) / 2;
    if (step < least) {
      answer.failure = std::string(KINGetReturnFlagName(flag));
      break;
    }
  }
  balance.load(t);
  answer.state = balance.state(vector.get());
  answer.evaluations = balance.evaluations;
  answer.factorizations = balance.factorizations;
  answer.processor = watch.processor();
  answer.wall = watch.wall();
  return answer;
}

}  // namespace wale::peers
