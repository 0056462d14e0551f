#include <arkode/arkode_erkstep.h>

#include "bench/peers/methods.hpp"
#include "bench/peers/motion.hpp"
#include "bench/peers/stopwatch.hpp"
#include "bench/peers/vectors.hpp"

namespace wale::peers {
namespace {

int rate(realtype t, N_Vector y, N_Vector out, void* motion) {
  return static_cast<Motion*>(motion)->rate(t, view(y), view(out)) ? 0 : 1;
}

ARKODE_ERKTableID table(Pair pair) {
  switch (pair) {
    case Pair::zonneveld_43:
      return ARKODE_ZONNEVELD_5_3_4;
    case Pair::sayfy_aburub_43:
      return ARKODE_SAYFY_ABURUB_6_3_4;
    case Pair::cash_karp_54:
      return ARKODE_CASH_KARP_6_4_5;
    case Pair::dormand_prince_54:
      return ARKODE_DORMAND_PRINCE_7_4_5;
  }
  return ARKODE_ERK_NONE;
}

struct Free {
  void operator()(void* memory) const { ERKStepFree(&memory); }
};

}  // namespace

Answer move_by_arkode(World& world, const State& start, double until, const Accuracy& accuracy, Pair pair) {
  const Stopwatch watch;
  const sundials::Context context;
  Motion motion(world, start);
  Eigen::VectorXd y = Motion::pack(start);
  const Vector vector = wrap(y, context);
  const std::unique_ptr<void, Free> memory(ERKStepCreate(rate, start.t, vector.get(), context));
  check(ERKStepSetUserData(memory.get(), &motion));
  check(ERKStepSStolerances(memory.get(), accuracy.relative, accuracy.absolute));
  check(ERKStepSetTableNum(memory.get(), table(pair)));
  check(ERKStepSetMaxNumSteps(memory.get(), -1));
  check(ERKStepSetStopTime(memory.get(), until));
  check(ERKStepSetErrFile(memory.get(), nullptr));
  double t = start.t;
  const int flag = ERKStepEvolve(memory.get(), until, vector.get(), &t, ARK_NORMAL);
  Answer answer;
  check(ERKStepGetNumSteps(memory.get(), &answer.steps));
  answer.state = motion.unpack(t, y);
  answer.evaluations = motion.evaluations();
  if (flag < 0) answer.failure = ERKStepGetReturnFlagName(flag);
  answer.processor = watch.processor();
  answer.wall = watch.wall();
  return answer;
}

}  // namespace wale::peers
