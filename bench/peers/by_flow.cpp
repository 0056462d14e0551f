#include <cvode/cvode.h>
#include <fmt/format.h>
#include <sunlinsol/sunlinsol_spgmr.h>

#include "bench/peers/balance.hpp"
#include "bench/peers/methods.hpp"
#include "bench/peers/stopwatch.hpp"
#include "bench/peers/vectors.hpp"

namespace wale::peers {
namespace {

// x' = f(x)/c: where it comes to rest does not depend on c, and CVODE takes the steps that it likes.
constexpr double c = 1;              // N s/m
constexpr double forever = 1e9;      // s
constexpr double step_error = 0.01;  // of the diameter: the way down may be rough, its end may not
constexpr int most_inner = 60, most_steps = 2000;
// At a saddle the step grows by many powers of ten, and the way down from there needs it small again.
constexpr int most_failures = 100;

Balance& of(void* balance) { return *static_cast<Balance*>(balance); }

int rate(realtype, N_Vector x, N_Vector out, void* balance) {
  const bool is_apart = of(balance).force(view(x), view(out));
  view(out) /= c;
  return is_apart ? 0 : 1;
}
int set_up(realtype, N_Vector x, N_Vector, booleantype may_keep, booleantype* is_new, realtype gamma, void* balance) {
  *is_new = !may_keep;
  if (!may_keep) of(balance).assemble(view(x));
  return of(balance).factor(c / gamma) ? 0 : 1;
}
/// I + γ K/c is what Newton's method solves with.
int precondition(realtype, N_Vector, N_Vector, N_Vector r, N_Vector z, realtype gamma, realtype, int, void* balance) {
  view(z) = view(r) * (c / gamma);
  of(balance).solve(view(z));
  return 0;
}
int multiply(N_Vector v, N_Vector out, realtype, N_Vector, N_Vector, void* balance, N_Vector) {
  of(balance).multiply(view(v), view(out));
  view(out) /= -c;
  return 0;
}

struct Free {
  void operator()(void* memory) const { CVodeFree(&memory); }
};

/// The way down at one load.
class Descent {
 public:
  Descent(Balance& balance, double reach, SUNContext context)
      : balance_(balance),
        x_(Eigen::VectorXd::Zero(balance.size())),
        force_(x_),
        vector_(wrap(x_, context)),
        solver_(SUNLinSol_SPGMR(vector_.get(), SUN_PREC_LEFT, most_inner, context), &SUNLinSolFree),
        memory_(CVodeCreate(CV_BDF, context)) {
    check(CVodeInit(memory_.get(), rate, 0, vector_.get()));
    check(CVodeSetUserData(memory_.get(), &balance));
    check(CVodeSStolerances(memory_.get(), 0, step_error * reach));
    check(CVodeSetLinearSolver(memory_.get(), solver_.get(), nullptr));
    check(CVodeSetPreconditioner(memory_.get(), set_up, precondition));
    check(CVodeSetJacTimes(memory_.get(), nullptr, multiply));
    check(CVodeSetMaxConvFails(memory_.get(), most_failures));
    check(CVodeSetErrFile(memory_.get(), nullptr));
  }

  /// Why the forces do not come below `enough`, N; empty if they do.
  std::string down_to(double enough) {
    double t = 0;
    for (int step = 0; step < most_steps; ++step) {
      if (balance_.force(x_, force_) && Balance::residual(force_) < enough) {
        balance_.settle(x_);
        return {};
      }
      const int flag = CVode(memory_.get(), forever, vector_.get(), &t, CV_ONE_STEP);
      ++steps_;
      if (flag < 0) return CVodeGetReturnFlagName(flag);
    }
    return fmt::format("{} steps do not do", most_steps);
  }

  long steps() const { return steps_; }

 private:
  Balance& balance_;
  Eigen::VectorXd x_, force_;
  Vector vector_;
  LinearSolver solver_;
  std::unique_ptr<void, Free> memory_;
  long steps_ = 0;
};

}  // namespace

Answer rest_by_flow(World& world, const State& start, double until, const Rest& rest) {
  const Stopwatch watch;
  const sundials::Context context;
  const Material& yarn = world.fabric().materials.front();
  Balance balance(world, start);
  Answer answer;
  for (int sample = 1; sample <= rest.samples && answer.failure.empty(); ++sample) {
    balance.load(start.t + (until - start.t) * sample / rest.samples);
    Descent descent(balance, yarn.diameter, context);
    answer.failure = descent.down_to(rest.tolerance * yarn.bending_rigidity / (yarn.diameter * yarn.diameter));
    answer.steps += descent.steps();
  }
  balance.conclude(answer, watch);
  return answer;
}

}  // namespace wale::peers
