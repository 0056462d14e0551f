#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <limits>

#include "sim/effects/beads.hpp"
#include "sim/parts.hpp"
#include "sim/world.hpp"
#include "tests/support/finite_difference.hpp"
#include "tests/support/make_fabric.hpp"
#include "tests/support/one_thread.hpp"

namespace wale {
namespace {

struct Case {
  std::string name;
  EffectSpec spec;
  ContactLaw law = ContactLaw::barrier;
  bool elastic = true;    ///< has a stiffness, no damping; else the other way round
  bool internal = true;   ///< yarns act on yarns only: forces sum to zero
  bool no_torque = true;  ///< for an internal effect: torques too
  bool exact_is_convex = false;
  bool viscous = true;              ///< dissipation is quadratic in the velocity
  double damping_tolerance = 1e-9;  ///< of the damping by differences, over its largest entry
  bool any_direction = true;        ///< for an internal effect: the same however the fabric is turned
};

/// Where every effect of the list is asked: rest lengths half tightened, a tether half way.
constexpr double now = 0.4;

std::vector<Case> cases() {
  const Tether moving{.segments = {0, 1, 7, 9},
                      .axes = {1, 0, 0.5},
                      .centre = {1e-4, 2e-4, 0},
                      .scale = {1.2, 0.9, 1},
                      .move = {3e-4, -1e-4, 2e-4},
                      .progress = Schedule::ramp(0, 1, 1)};
  const Contact inflated{.sampling = 0.05, .inflate_beads = true};
  // One taut between two yarns, one slack, and one between segments that share control points.
  const Knots knots{.knots = {{0, 9, 0.2, 0.7, 0.3e-3}, {1, 12, 0.5, 0.1, 9e-3}, {2, 4, 0.9, 0.3, 0.2e-3}}};
  const Obstacle plane{.centre = {0, 0, -0.1e-3}, .axis = Vec3(0.1, -0.2, 1).normalized(), .stiffness = 200};
  const Obstacle cylinder{.shape = Obstacle::Shape::cylinder,
                          .centre = {0, -0.5e-3, -0.8e-3},
                          .axis = Vec3(0.3, 1, 0.2).normalized(),
                          .radius = 0.6e-3,
                          .stiffness = 200,
                          .move = {0.2e-3, 1e-3, 0.4e-3},
                          .progress = Schedule::ramp(0, 1, 1)};
  Obstacle sphere = cylinder;
  sphere.shape = Obstacle::Shape::sphere;
  sphere.radius = 1.5e-3;
  sphere.centre = {0, 0.3e-3, -1.6e-3};
  sphere.on.materials = {0};
  const Pressure pressure{
      .from = 100, .to = 900, .axis = {0.6, 0, 0.8}, .spacing = 1e-3, .progress = Schedule::ramp(0, 1, 1)};
  using enum ContactLaw;
  return {
      {"StretchAtOneNode", Stretch{.nodes = 1}},
      {"StretchAtThreeNodes", Stretch{.nodes = 3}},
      {"Bend", Bend{}},
      {"BendOfYarnThatHasSet", Bend{.rest = RestShape::as_laid}},
      {"Gravity", Gravity{{1, -9.81, 2}}, barrier, true, false, false, true},
      {"Drag", Drag{}, barrier, false, false, false, true},
      {"BarrierContact", Contact{}, barrier},
      {"QuadraticContact", Contact{}, quadratic},
      {"CoreShellContact", Contact{}, core_shell},
      {"InflatedContact", inflated, quadratic},
      // Sliding beads rub where their centres are, not where they touch: a couple is left over.
      {"ContactDamping", ContactDamping{.tangential = 5, .normal = 40}, barrier, false, true, false, true},
      {"NormalContactDamping", ContactDamping{.normal = 40}, barrier, false, true, true, true},
      {"StickingFriction", Friction{.coefficient = 0.4, .threshold = 1}, barrier, false, true, false, true, false},
      // Its direction turns quickly where two beads hardly slide.
      {"SlidingFriction", Friction{.coefficient = 0.4, .threshold = 1e-3}, core_shell, false, true, false, true, false,
       1e-7},
      {"Tether", moving, barrier, true, false, false, true},
      {"Knots", knots},
      {"Plates", Plates{.gap = 0.2e-3}, barrier, true, false, false, true},
      {"Plane", plane, barrier, true, false, false, true},
      {"Cylinder", cylinder, barrier, true, false, false},
      {"SphereForOneYarn", sphere, barrier, true, false, false},
      {"Pressure", pressure, barrier, true, true, false, false, true, 1e-9, false},
      {"Twist", Twist{.from = 1e-7, .to = 3e-7}, barrier, true, true, false, false, true, 1e-9, false},
      {"GravityOfOneYarn", Gravity{{1, -9.81, 2}, {{0}, {}}}, barrier, true, false, false, true},
      {"GravityOfARegion", Gravity{{1, -9.81, 2}, {{0}, {2, 3, 12}}}, barrier, true, false, false, true},
  };
}

/// All that an effect may be asked for, at one state.
struct Answer {
  double energy = 0, dissipation = 0;
  Points force;
  Stiffness stiffness, damping, convex;
  explicit Answer(Eigen::Index points)
      : force(Points::Zero(3, points)),
        stiffness(static_cast<int>(points)),
        damping(static_cast<int>(points)),
        convex(static_cast<int>(points)) {}
  Load all() { return {&energy, &force, &stiffness, &damping, &dissipation, &convex}; }
};

class EveryEffect : public testing::TestWithParam<Case> {
 protected:
  struct Bench {
    Fabric fabric;
    RestSchedules rest = Schedule::ramp(0, 1, 0.8);
    State start, at;
    std::unique_ptr<Parts> parts;
    std::unique_ptr<Effect> effect;
  };

  static std::unique_ptr<Bench> bench(Fabric fabric) {
    auto made = std::make_unique<Bench>();
    made->fabric = std::move(fabric);
    for (std::size_t i = 0; i < made->fabric.segments.size(); ++i)
      made->fabric.segments[i].knitted = (0.8 + 0.02 * static_cast<double>(i % 7)) * made->fabric.segments[i].length;
    made->start = shaken_state(made->fabric, 0, 1);
    made->at = shaken_state(made->fabric, 0.1, 2);
    shake(made->at.q, 1e-5, 3);
    made->at.t = now;
    made->parts = std::make_unique<Parts>(Parts{made->fabric, made->rest, made->start});
    made->effect = std::visit([&](const auto& spec) { return make(spec, *made->parts); }, GetParam().spec);
    return made;
  }
  std::unique_ptr<Bench> small(unsigned seed) { return bench(crossing_yarns(GetParam().law, seed)); }

  static Answer ask(Effect& effect, const State& at) {
    Answer answer(at.q.cols());
    effect.prepare(at);
    Load load = answer.all();
    effect.add(at, load);
    return answer;
  }

  static Points force_at(Effect& effect, State at, const Points* q, const Points* v) {
    if (q) at.q = *q;
    if (v) at.v = *v;
    Points force = Points::Zero(3, at.q.cols());
    Load load{.force = &force};
    effect.prepare(at);
    effect.add(at, load);
    return force;
  }

  static Eigen::VectorXd one_number(Effect& effect, const State& at, double* Load::*which) {
    Eigen::VectorXd number = Eigen::VectorXd::Zero(1);
    Load load;
    load.*which = number.data();
    effect.prepare(at);
    effect.add(at, load);
    return number;
  }

 private:
  OneThread one_thread_;
};

constexpr unsigned seeds[] = {11, 12, 13};
constexpr double small_move = 2e-9;   // m
constexpr double small_speed = 1e-3;  // m/s

TEST_P(EveryEffect, HasAForceThatIsTheSlopeOfItsEnergyAndItsDissipation) {
  for (const unsigned seed : seeds) {
    const auto b = small(seed);
    const Answer answer = ask(*b->effect, b->at);
    const auto energy = [&](const Points& q) {
      State there = b->at;
      there.q = q;
      return one_number(*b->effect, there, &Load::energy);
    };
    const auto dissipation = [&](const Points& v) {
      State there = b->at;
      there.v = v;
      return one_number(*b->effect, there, &Load::dissipation);
    };
    const Eigen::VectorXd expected =
        -(slope_of(energy, b->at.q, 1e-8) + slope_of(dissipation, b->at.v, small_speed)).transpose();
    ASSERT_GT(expected.norm(), 0) << "the effect is asleep in this state";
    EXPECT_LT((answer.force.reshaped() - expected).cwiseAbs().maxCoeff(), 1e-6 * expected.cwiseAbs().maxCoeff());
  }
}

TEST_P(EveryEffect, HasAStiffnessThatIsTheSlopeOfItsForceByPosition) {
  for (const unsigned seed : seeds) {
    const auto b = small(seed);
    b->at.v.setZero();  // the stiffness is that of the energy alone
    const Eigen::MatrixXd stiffness = dense(ask(*b->effect, b->at).stiffness);
    const Eigen::MatrixXd expected =
        -slope_of([&](const Points& q) { return force_at(*b->effect, b->at, &q, nullptr).reshaped().eval(); }, b->at.q,
                  small_move);
    EXPECT_LE((stiffness - expected).cwiseAbs().maxCoeff(), 1e-6 * expected.cwiseAbs().maxCoeff() + 1e-12);
  }
}

TEST_P(EveryEffect, HasADampingThatIsTheSlopeOfItsForceByVelocity) {
  for (const unsigned seed : seeds) {
    const auto b = small(seed);
    const Eigen::MatrixXd damping = dense(ask(*b->effect, b->at).damping);
    const Eigen::MatrixXd expected =
        -slope_of([&](const Points& v) { return force_at(*b->effect, b->at, nullptr, &v).reshaped().eval(); }, b->at.v,
                  small_speed);
    EXPECT_EQ(expected.cwiseAbs().maxCoeff() > 0, !GetParam().elastic);
    EXPECT_LE((damping - expected).cwiseAbs().maxCoeff(),
              GetParam().damping_tolerance * expected.cwiseAbs().maxCoeff());
  }
}

/// Friction loses twice its dissipation while it sticks, and as much as that once it slides.
TEST_P(EveryEffect, LosesTwiceItsDissipationAndNeverGains) {
  for (const unsigned seed : seeds) {
    const auto b = small(seed);
    const Answer answer = ask(*b->effect, b->at);
    EXPECT_EQ(answer.dissipation > 0, !GetParam().elastic);
    if (GetParam().elastic) continue;
    EXPECT_EQ(answer.energy, 0);
    const double lost = -answer.force.cwiseProduct(b->at.v).sum();
    EXPECT_LE(lost, (2 + 1e-12) * answer.dissipation);
    EXPECT_GE(lost, (GetParam().viscous ? 2 - 1e-12 : 1) * answer.dissipation);
  }
}

TEST_P(EveryEffect, AddsToWhatIsThereAndNeverClears) {
  const auto b = small(11);
  const Answer once = ask(*b->effect, b->at);
  Answer twice(b->at.q.cols());
  Load load = twice.all();
  b->effect->add(b->at, load);
  b->effect->add(b->at, load);
  const auto near = [](const auto& a, const auto& c) { return (a - 2 * c).norm() <= 1e-13 * c.norm(); };
  EXPECT_NEAR(twice.energy, 2 * once.energy, 1e-13 * std::abs(once.energy));
  EXPECT_NEAR(twice.dissipation, 2 * once.dissipation, 1e-13 * once.dissipation);
  EXPECT_TRUE(near(twice.force, once.force));
  EXPECT_TRUE(near(dense(twice.stiffness), dense(once.stiffness)));
  EXPECT_TRUE(near(dense(twice.damping), dense(once.damping)));
  EXPECT_TRUE(near(dense(twice.convex), dense(once.convex)));
}

TEST_P(EveryEffect, AnswersTheSameWhenLessIsAsked) {
  const auto b = small(12);
  const Answer all = ask(*b->effect, b->at);
  Answer some(b->at.q.cols());
  for (Load load :
       {Load{.energy = &some.energy}, Load{.force = &some.force}, Load{.stiffness = &some.stiffness},
        Load{.damping = &some.damping}, Load{.dissipation = &some.dissipation}, Load{.convex = &some.convex}, Load{}})
    b->effect->add(b->at, load);
  EXPECT_EQ(some.energy, all.energy);
  EXPECT_EQ(some.dissipation, all.dissipation);
  EXPECT_EQ(some.force, all.force);
  EXPECT_EQ(dense(some.stiffness), dense(all.stiffness));
  EXPECT_EQ(dense(some.damping), dense(all.damping));
  EXPECT_EQ(dense(some.convex), dense(all.convex));
}

TEST_P(EveryEffect, HasForcesAndTorquesThatSumToZeroIfInternal) {
  for (const unsigned seed : seeds) {
    const auto b = small(seed);
    const Points force = ask(*b->effect, b->at).force;
    const double size = force.cwiseAbs().maxCoeff();
    EXPECT_EQ(force.rowwise().sum().norm() < 1e-12 * size, GetParam().internal);
    Vec3 torque = Vec3::Zero();
    for (Eigen::Index k = 0; k < force.cols(); ++k) torque += b->at.q.col(k).cross(force.col(k));
    EXPECT_EQ(torque.norm() < 1e-12 * size * 1e-3, GetParam().no_torque);
  }
}

TEST_P(EveryEffect, KeepsItsEnergyInARigidMotionIfInternal) {
  if (!GetParam().internal || !GetParam().any_direction) return;
  const auto b = small(13);
  const Answer before = ask(*b->effect, b->at);
  const Mat3 turn = Eigen::Quaterniond(0.4, -0.2, 0.7, 0.5).normalized().toRotationMatrix();
  State moved = b->at;
  moved.q = (turn * b->at.q).colwise() + Vec3(0.01, -0.02, 0.005);
  moved.v = turn * b->at.v;
  const Answer after = ask(*b->effect, moved);
  EXPECT_NEAR(after.energy, before.energy, 1e-10 * before.energy);
  EXPECT_NEAR(after.dissipation, before.dissipation, 1e-10 * before.dissipation);
  EXPECT_LT((after.force - turn * before.force).norm(), 1e-10 * before.force.norm());
}

TEST_P(EveryEffect, AnswersTheSameBitsForAnyNumberOfThreads) {
  const auto b = bench(woven_yarns(8, 30, 5));
  const auto with = [&](int count) {
    omp_set_num_threads(count);
    return ask(*b->effect, b->at);
  };
  const Answer one = with(1);
  Eigen::VectorXd expected, product;
  const Eigen::VectorXd probe = b->at.v.reshaped();
  ASSERT_GT(one.force.norm(), 0);
  for (const int count : {2, 3}) {
    const Answer many = with(count);
    EXPECT_EQ(one.energy, many.energy);
    EXPECT_EQ(one.dissipation, many.dissipation);
    EXPECT_EQ(one.force, many.force);
    for (const auto matrix : {&Answer::stiffness, &Answer::damping, &Answer::convex}) {
      (one.*matrix).multiply(probe, expected);
      (many.*matrix).multiply(probe, product);
      EXPECT_EQ(expected, product);
    }
  }
}

TEST_P(EveryEffect, AnswersTheSameBitsWhereverItWasAskedBefore) {
  const auto fresh = small(12), travelled = small(12);
  const Answer expected = ask(*fresh->effect, fresh->at);
  for (int i = 20; i > 0; --i) {
    State elsewhere = travelled->at;
    elsewhere.t = 0.05 * i;
    elsewhere.q.row(i % 3) *= 1 + 0.02 * i;
    ask(*travelled->effect, elsewhere);
  }
  const Answer again = ask(*travelled->effect, travelled->at);
  EXPECT_EQ(again.energy, expected.energy);
  EXPECT_EQ(again.dissipation, expected.dissipation);
  EXPECT_EQ(again.force, expected.force);
  EXPECT_EQ(dense(again.stiffness), dense(expected.stiffness));
  EXPECT_EQ(dense(again.damping), dense(expected.damping));
  EXPECT_EQ(dense(again.convex), dense(expected.convex));
}

TEST_P(EveryEffect, HasAConvexStiffnessThatIsPositiveSemidefinite) {
  for (const unsigned seed : seeds) {
    const auto b = small(seed);
    const Answer answer = ask(*b->effect, b->at);
    for (const auto matrix : {&Answer::convex, &Answer::damping}) {
      const Eigen::MatrixXd k = dense(answer.*matrix);
      const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k).eigenvalues();
      EXPECT_GE(values.minCoeff(), -1e-12 * values.maxCoeff());
    }
    EXPECT_TRUE(!GetParam().exact_is_convex || dense(answer.convex) == dense(answer.stiffness));
  }
}

INSTANTIATE_TEST_SUITE_P(Effects, EveryEffect, testing::ValuesIn(cases()),
                         [](const auto& of) { return of.param.name; });

/// The true force on a straight yarn of ten millimetres, which is moved by `by` from where the stage began.
Vec3 total_force(const EffectSpec& spec, const Vec3& by, double t) {
  const Fabric fabric = straight_rod(10e-3, 8);
  const RestSchedules laid = 0.0;
  const State start = shaken_state(fabric, 0, 1);
  Parts parts{fabric, laid, start};
  const auto effect = std::visit([&](const auto& of) { return make(of, parts); }, spec);
  State at = start;
  at.t = t;
  at.q.colwise() += by;
  Points force = Points::Zero(3, at.q.cols());
  Load load{.force = &force};
  effect->add(at, load);
  return force.rowwise().sum();
}

TEST(Gravity, PullsByMassTimesItsAcceleration) {
  const Vec3 g(1, -9, 3);
  EXPECT_LT((total_force(Gravity{g}, Vec3::Zero(), 0) - 77e-6 * 10e-3 * g).norm(), 1e-18);
}

TEST(Tether, HoldsWhatItHasMovedAndScaledToItsTarget) {
  // About its middle, so that scaling moves no mean: the mean lies at p move.
  const Tether tether{.segments = {0, 1, 2, 3, 4, 5, 6, 7},
                      .stiffness = 50,
                      .axes = {1, 0.5, 0},
                      .centre = {5e-3, 0, 0},
                      .scale = {3, 1, 1},
                      .move = {2e-3, 4e-3, 1e-3},
                      .progress = Schedule::ramp(0, 1, 10)};
  EXPECT_LT(total_force(tether, {0.6e-3, 1.2e-3, 0}, 3).norm(), 1e-15);
  const Vec3 off(1e-4, -2e-4, 5e-4), expected = -2 * 50 * 10e-3 * Vec3(1, 0.25, 0).cwiseProduct(off);
  EXPECT_LT((total_force(tether, Vec3(0.6e-3, 1.2e-3, 0) + off, 3) - expected).norm(), 1e-14);
}

TEST(Tether, LeavesAnEvenlyStretchedYarnAloneWhenItsTargetIsThatStretch) {
  const Fabric fabric = straight_rod(10e-3, 8);
  const RestSchedules laid = 0.0;
  State at = shaken_state(fabric, 0, 1);
  const State start = at;
  Parts parts{fabric, laid, start};
  const auto effect =
      make(Tether{.segments = {1, 2, 5}, .centre = {2e-3, 0, 0}, .scale = {1.5, 1, 1}, .progress = 1.0}, parts);
  at.q.row(0) = (2e-3 + 1.5 * (start.q.row(0).array() - 2e-3)).matrix();
  double energy = 0;
  Load load{.energy = &energy};
  effect->add(at, load);
  EXPECT_LT(energy, 1e-30);
}

TEST(Plates, PushBackByTheDepthBeyondThem) {
  const Plates plates{.stiffness = 200, .gap = 1e-3};
  EXPECT_EQ(total_force(plates, {0, 0, 0.49e-3}, 0), Vec3::Zero());
  EXPECT_LT((total_force(plates, {0, 0, 0.7e-3}, 0) - Vec3(0, 0, -2 * 200 * 10e-3 * 0.2e-3)).norm(), 1e-15);
  EXPECT_LT((total_force(plates, {0, 0, -0.6e-3}, 0) - Vec3(0, 0, 2 * 200 * 10e-3 * 0.1e-3)).norm(), 1e-15);
}

/// A yarn under tension everywhere: nothing of the stretch stiffness is negative, so nothing is left out.
TEST(Stretch, HasTheSameStiffnessConvexOrNotWhereTheYarnIsTaut) {
  Fabric fabric = straight_rod(5e-3, 6);
  shake(fabric.points, 1e-5, 4);
  fabric.points *= 1.2;
  const RestSchedules laid = 0.0;
  State at = shaken_state(fabric, 0, 1);
  Parts parts{fabric, laid, at};
  const auto stretch = make(Stretch{}, parts);
  Stiffness exact(9), convex(9);
  Load both{.stiffness = &exact, .convex = &convex};
  stretch->add(at, both);
  EXPECT_EQ(dense(exact), dense(convex));
}

TEST(Bend, HasTheSameStiffnessConvexOrNotInAStraightYarn) {
  const Fabric fabric = straight_rod(5e-3, 6);
  const RestSchedules laid = 0.0;
  State at = shaken_state(fabric, 0, 1);
  Parts parts{fabric, laid, at};
  const auto bend = make(Bend{}, parts);
  Stiffness exact(9), convex(9);
  Load both{.stiffness = &exact, .convex = &convex};
  bend->add(at, both);
  EXPECT_LT((dense(exact) - dense(convex)).norm(), 1e-12 * dense(exact).norm());
}

/// A yarn laid in an arc of radius 2 mm.
Fabric arc_of_yarn(int segments) {
  constexpr double radius = 2e-3, turn = 0.25;
  Points points(3, segments + 3);
  for (int k = 0; k < segments + 3; ++k) points.col(k) = radius * Vec3(std::cos(turn * k), std::sin(turn * k), 0);
  Fabric fabric;
  fabric.materials = {Material{}};
  add_yarn(fabric, points, turn * radius);
  return fabric;
}

struct Bent {
  double energy = 0;
  Points force;
};

Bent bent(const Fabric& fabric, const RestSchedules& rest, const Points& q) {
  State at = shaken_state(fabric, 0, 1);
  Parts parts{fabric, rest, at};
  const auto bend = make(Bend{.rest = RestShape::as_laid}, parts);
  at.q = q;
  Bent found{0, Points::Zero(3, q.cols())};
  Load load{.energy = &found.energy, .force = &found.force};
  bend->add(at, load);
  return found;
}

TEST(Bend, PullsAtNothingInYarnThatHasSetAsItLies) {
  const Fabric fabric = arc_of_yarn(8);
  const double moment = fabric.materials[0].bending_rigidity / 2e-3;
  EXPECT_LT(std::abs(bent(fabric, 0.0, fabric.points).energy), 1e-12 * moment);
  EXPECT_LT(bent(fabric, 0.0, fabric.points).force.norm(), 1e-12 * moment / 2e-3);
}

TEST(Bend, HasARestShapeThatShrinksWithTheRestLength) {
  Fabric fabric = arc_of_yarn(8);
  for (Segment& segment : fabric.segments) segment.knitted = 0.9 * segment.length;
  const double force = fabric.materials[0].bending_rigidity / (2e-3 * 2e-3);
  EXPECT_LT(bent(fabric, 1.0, 0.9 * fabric.points).force.norm(), 1e-12 * force);
  EXPECT_GT(bent(fabric, 1.0, fabric.points).force.norm(), 1e-3 * force);
}

/// Half as strong a bend: ½ EI κ_0²/4 a length, within the rounding at κ = 0.
TEST(Bend, CostsTheSquareOfTheDepartureFromTheRestCurvature) {
  const Fabric fabric = arc_of_yarn(64);
  const double curvature = 1 / 2e-3, length = 64 * 0.25 * 2e-3;
  const double expected = fabric.materials[0].bending_rigidity * length * curvature * curvature / 8;
  EXPECT_NEAR(bent(fabric, 0.0, 2 * fabric.points).energy, expected, 0.03 * expected);
}

TEST(Bend, IsSmoothWhereYarnThatHasSetIsStraight) {
  const Fabric fabric = arc_of_yarn(5);
  const Points straight = straight_points({0, 0, 0}, {2.5e-3, 0, 0}, 5);
  Points bowed = straight;
  shake(bowed, 1e-6, 6);
  for (const Points& q : {straight, bowed}) {
    const Bent here = bent(fabric, 0.0, q);
    const auto energy = [&](const Points& there) {
      return Eigen::VectorXd::Constant(1, bent(fabric, 0.0, there).energy).eval();
    };
    const Eigen::VectorXd expected = -slope_of(energy, q, 1e-9).transpose();
    const double force = fabric.materials[0].bending_rigidity / (2e-3 * 2e-3);
    EXPECT_LT((here.force.reshaped() - expected).cwiseAbs().maxCoeff(), 1e-6 * force);
  }
}

/// Eqs. (17)-(20) as corrected, summed over every pair of beads with no list: V and the closest pair.
std::pair<double, double> sum_over_all_beads(const Fabric& fabric, const Points& q, double alpha, double screening) {
  struct Bead {
    Vec3 at;
    int segment;
    double arc, share;
  };
  std::vector<Bead> beads;
  for (const Yarn& yarn : fabric.yarns) {
    double arc = 0;
    for (int i = yarn.first_segment; i < yarn.first_segment + yarn.segments; ++i) {
      const double l = fabric.segment(i).knitted, d = fabric.material_of(i).diameter;
      const int n = static_cast<int>(std::ceil(l / (d * std::sqrt(6 * alpha * (1 + alpha)))));
      for (int k = 1; k <= n; ++k) {
        const double s = (2.0 * k - 1) / (2 * n);
        beads.push_back({combine(q, fabric.first_point(i), basis(s).value), i, arc + s * l, l / n});
      }
      arc += l;
    }
  }
  double energy = 0, closest = 1e9;
  for (std::size_t i = 0; i < beads.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Bead &a = beads[i], &b = beads[j];
      if (a.segment == b.segment) continue;
      const Material &p = fabric.material_of(a.segment), &r = fabric.material_of(b.segment);
      const double d = (p.diameter + r.diameter) / 2, delta = (a.at - b.at).norm() / d;
      const bool same_yarn = fabric.segment(a.segment).yarn == fabric.segment(b.segment).yarn;
      if (same_yarn && std::abs(a.arc - b.arc) < screening * d) continue;
      closest = std::min(closest, delta);
      if (delta < 1) energy += a.share * b.share * p.contact_stiffness * (1 / (delta * delta) + delta * delta - 2);
    }
  return {energy, closest};
}

TEST(Contact, MissesNoPairOfBeadsWhileTheYarnsMove) {
  Fabric fabric = woven_yarns(3, 8, 9);
  const RestSchedules tight = 1.0;
  State at = shaken_state(fabric, 1, 5);
  Parts parts{fabric, tight, at};
  const Contact spec;
  const auto contact = make(spec, parts);
  for (int step = 0; step < 40; ++step) {
    at.q += 2e-5 * at.v;
    contact->prepare(at);
    double energy = 0;
    Load load{.energy = &energy};
    contact->add(at, load);
    const auto [expected, closest] = sum_over_all_beads(fabric, at.q, spec.sampling, spec.screening);
    ASSERT_GT(expected, 0);
    EXPECT_NEAR(energy, expected, 1e-10 * expected) << step;
    EXPECT_NEAR(contact->closest(), closest, 1e-10) << step;
  }
}

/// Ding et al. 2023, Eqs. (A.4), (A.5): with the bound's number of beads the inflated diameter is (1 + alpha) d.
TEST(Beads, AreInflatedByAlphaWhenTheirNumberIsTheBound) {
  const double d = 0.5e-3, alpha = 0.03, spacing = d * std::sqrt(6 * alpha * (1 + alpha));
  EXPECT_EQ(beads_per_segment(3.999 * spacing, d, alpha), 4);
  EXPECT_EQ(beads_per_segment(4.001 * spacing, d, alpha), 5);
  EXPECT_NEAR(inflated_diameter(d, spacing), (1 + alpha) * d, 1e-15);
}

/// How far a quadratic model of what friction loses, with `secant`, lies above that at its lowest of many velocities, W
/// over what is lost at the first.
double lowest_of_model(double secant) {
  const Fabric fabric = crossing_yarns(ContactLaw::core_shell, 11);
  World world(fabric, {Friction{.coefficient = 0.4, .threshold = 1e-3}}, 0.0, at_rest(fabric));
  const State at = shaken_state(fabric, 0.1, 2);
  world.prepare(at);
  double lost = 0;
  Points force;
  Stiffness damping(static_cast<int>(at.q.cols()));
  Load load{.force = &force, .damping = &damping, .dissipation = &lost, .secant = secant};
  world.evaluate(at, load);
  double lowest = std::numeric_limits<double>::infinity();
  for (unsigned seed = 0; seed < 20; ++seed)
    for (const double times : {0.01, 0.3, 1.0, 3.0}) {
      // Half of them stop what slides, and turn it round.
      Points change = seed % 2 ? Points(-times * at.v) : Points(Points::Zero(3, at.v.cols()));
      shake(change, 0.1 * times, seed);
      Eigen::VectorXd bent;
      damping.multiply(change.reshaped(), bent);
      double then = 0;
      State moved = at;
      moved.v += change;
      Load loss{.dissipation = &then};
      world.evaluate(moved, loss);
      const double model = lost - force.cwiseProduct(change).sum() + change.reshaped().dot(bent) / 2;
      lowest = std::min(lowest, (model - then) / lost);
    }
  return lowest;
}

TEST(Friction, LosesNoMoreThanAModelWithSecantsSays) {
  EXPECT_GT(lowest_of_model(1), -1e-12);
  EXPECT_LT(lowest_of_model(0), -0.01);
  EXPECT_LT(lowest_of_model(0.5), lowest_of_model(1));
}

TEST(Gravity, OfARegionIsTheWeightOfItsSegmentsOfThoseYarns) {
  const OneThread one_thread;
  Fabric fabric = straight_rod(0.1, 8);
  fabric.materials.push_back(fabric.materials.front());
  for (std::size_t i = 4; i < 8; ++i) fabric.segments[i].material = 1;
  const State state = at_rest(fabric);
  World world(fabric, {Gravity{{0, -10, 0}, {{1}, {3, 4, 6}}}}, 0.0, state);
  Points force = Points::Zero(3, state.q.cols());
  Load load{.force = &force};
  world.evaluate(state, load);
  EXPECT_NEAR(force.row(1).sum(), -10 * fabric.materials[1].linear_density * 0.1 * 2 / 8, 1e-15);
}

}  // namespace
}  // namespace wale
