#include <cvode/cvode.h>
#include <sunlinsol/sunlinsol_spgmr.h>

#include "bench/peers/implicit_matrix.hpp"
#include "bench/peers/methods.hpp"
#include "bench/peers/motion.hpp"
#include "bench/peers/stopwatch.hpp"
#include "bench/peers/vectors.hpp"

namespace wale::peers {
namespace {

// BDF of higher order amplifies undamped oscillations, which a yarn has along its length: runs away within 0.1 ms.
constexpr int a_stable_order = 2;

struct System {
  Motion motion;
  ImplicitMatrix matrix;
};

int rate(realtype t, N_Vector y, N_Vector out, void* system) {
  return static_cast<System*>(system)->motion.rate(t, view(y), view(out)) ? 0 : 1;
}

int set_up(realtype t, N_Vector y, N_Vector, booleantype may_keep, booleantype* is_new, realtype gamma, void* of) {
  System& system = *static_cast<System*>(of);
  *is_new = !may_keep;
  if (!may_keep) system.matrix.assemble(system.motion.unpack(t, view(y)));
  return system.matrix.factor(gamma) ? 0 : 1;
}

int precondition(realtype, N_Vector, N_Vector, N_Vector r, N_Vector z, realtype, realtype, int, void* system) {
  view(z) = view(r);
  static_cast<System*>(system)->matrix.solve(view(z));
  return 0;
}

struct Free {
  void operator()(void* memory) const { CVodeFree(&memory); }
};

}  // namespace

Answer move_by_cvode(World& world, const State& start, double until, const Accuracy& accuracy) {
  const Stopwatch watch;
  const sundials::Context context;
  System system{Motion(world, start), ImplicitMatrix(world)};
  Eigen::VectorXd y = Motion::pack(start);
  Eigen::VectorXd absolute = Eigen::VectorXd::Constant(y.size(), accuracy.absolute);
  absolute.tail(y.size() / 2).setConstant(accuracy.absolute_speed);
  const Vector vector = wrap(y, context), least = wrap(absolute, context);
  const LinearSolver solver(SUNLinSol_SPGMR(vector.get(), SUN_PREC_LEFT, 10, context), &SUNLinSolFree);
  const std::unique_ptr<void, Free> memory(CVodeCreate(CV_BDF, context));
  check(CVodeInit(memory.get(), rate, start.t, vector.get()));
  check(CVodeSetUserData(memory.get(), &system));
  check(CVodeSVtolerances(memory.get(), accuracy.relative, least.get()));
  check(CVodeSetLinearSolver(memory.get(), solver.get(), nullptr));
  check(CVodeSetPreconditioner(memory.get(), set_up, precondition));
  check(CVodeSetMaxOrd(memory.get(), a_stable_order));
  check(CVodeSetMaxNumSteps(memory.get(), -1));
  check(CVodeSetStopTime(memory.get(), until));
  check(CVodeSetErrFile(memory.get(), nullptr));
  double t = start.t;
  const int flag = CVode(memory.get(), until, vector.get(), &t, CV_NORMAL);
  Answer answer;
  check(CVodeGetNumSteps(memory.get(), &answer.steps));
  answer.state = system.motion.unpack(t, y);
  answer.evaluations = system.motion.evaluations();
  answer.factorizations = system.matrix.factorizations();
  if (flag < 0) answer.failure = CVodeGetReturnFlagName(flag);
  answer.processor = watch.processor();
  answer.wall = watch.wall();
  return answer;
}

}  // namespace wale::peers
