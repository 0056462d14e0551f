#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>
#include <map>

#include "sim/effects/beads.hpp"
#include "sim/tile.hpp"
#include "sim/world.hpp"
#include "tests/support/cells.hpp"
#include "tests/support/finite_difference.hpp"
#include "tests/support/make_fabric.hpp"
#include "tests/support/one_thread.hpp"

namespace wale {
namespace {

// Of the yarn as laid: then loops press on each other as in a tight fabric.
constexpr double shrinkage = 0.66;

/// A repeat whose control points and periods are moved a little out of every symmetry; its wale period leads to the
/// repeat `lean` places to the right of the one above, which is as good a description of the same fabric. With a
/// curvature, 1/m, it is bent.
struct Cell {
  Fabric fabric;
  Ties ties;
  Points free;  ///< the columns that move by themselves, the two periods last

  explicit Cell(const std::vector<std::string>& picture, int lean = 0, Curls curls = Curls::never, double curvature = 0)
      : fabric(repeat(picture, curls)), ties(fabric) {
    const Points q = shrinkage * points_and_periods(fabric);
    free.resize(3, ties.free_columns());
    // From behind, so that what follows a column is overwritten by it.
    for (int i = 0; i < ties.columns(); ++i)
      free.col(ties.free_column(ties.columns() - 1 - i)) = q.col(ties.columns() - 1 - i);
    shake(free, 0.02e-3, 3);
    free.rightCols<1>() += lean * free.rightCols<2>().col(0);
    if (curls == Curls::never) return;
    // The course period lies along x.
    free.col(free.cols() - 2).tail<2>().setZero();
    free(2, free.cols() - 1) = curvature * curl_unit(*fabric.cell);
    for (int i = 0; i + 2 < ties.free_columns(); ++i)
      free.col(i) = rolled_up(free.col(i), cylinder(*fabric.cell, free.rightCols<2>()));
  }
  Points q() const { return q(free); }
  /// All columns, where the free ones are.
  Points q(const Points& free_ones) const {
    Points all = ties.spread(free_ones);
    ties.follow(all);
    return all;
  }

 private:
  static Fabric repeat(const std::vector<std::string>& picture, Curls curls) {
    Fabric fabric = compile_repeat(picture, 9).fabric;
    fabric.cell->curls = curls;
    return fabric;
  }
};

State state_of(const Points& q, const Points& v) { return {.t = 0, .q = q, .v = v, .step = 0}; }

/// One effect alone, its force on what may move, and its potential: energy, or dissipation if it is of velocity.
class Alone {
 public:
  Alone(const Cell& cell, const EffectSpec& spec)
      : cell_(cell), world_(cell.fabric, {spec}, Schedule(1.0), at_rest(cell.fabric)) {}

  double potential(const Points& free, const Points& velocity) {
    double energy = 0, dissipation = 0;
    evaluate(free, velocity, {.energy = &energy, .dissipation = &dissipation});
    return energy + dissipation;
  }
  Points force(const Points& free, const Points& velocity) {
    Points force;
    evaluate(free, velocity, {.force = &force});
    return world_.ties().gather(force);
  }
  Eigen::MatrixXd second(const Points& free, const Points& velocity, bool elastic) {
    Stiffness by_all(cell_.ties.columns()), by_free(cell_.ties.free_columns());
    Points force;
    Load load{.force = &force};
    (elastic ? load.stiffness : load.damping) = &by_all;
    evaluate(free, velocity, load);
    world_.ties().gather(by_all, by_free);
    if (elastic) world_.ties().add_turning(force, by_free);
    return dense(by_free);
  }

 private:
  void evaluate(const Points& free, const Points& velocity, Load load) {
    const Points q = cell_.q(free);
    State at = state_of(q, Points::Zero(3, q.cols()));
    world_.prepare(at);
    at.v = world_.ties().spread(velocity);
    world_.evaluate(at, load);
  }
  const Cell& cell_;
  World world_;
};

const std::vector<std::vector<std::string>> repeats{{"k"}, {"p", "k"}, {"kp", "pk"}};

double largest(const Eigen::MatrixXd& matrix) { return matrix.cwiseAbs().maxCoeff(); }

/// How many pairs of segments touch, by periods between them.
std::map<std::pair<int, int>, int> touching(const Cell& cell) {
  Beads beads(cell.fabric, 0.03, 1.6, 0.4);
  beads.prepare(cell.q());
  EXPECT_GT(beads.closest(), 0.3);
  std::map<std::pair<int, int>, int> count;
  for (std::size_t p = 0; p < beads.pairs().size(); ++p) {
    const auto& [a, b, image] = beads.pairs()[p];
    const Eigen::Vector2i& by = beads.images()[static_cast<std::size_t>(image)];
    count[{by.x(), by.y()}] += beads.distance(p) < beads.diameter(a, b);
  }
  return count;
}

TEST(PeriodicCell, TouchesItselfAcrossBothPeriodsAndDiagonally) {
  const OneThread one;
  auto straight = touching(Cell({"k"})), right = touching(Cell({"k"}, 1)), left = touching(Cell({"k"}, -1));
  EXPECT_GT((straight[{1, 0}]), 0);
  EXPECT_GT((straight[{0, 1}]), 0);
  EXPECT_GT((right[{-1, 1}]), 0);
  EXPECT_GT((left[{1, 1}]), 0);
}

struct EnergySlopes {
  Eigen::VectorXd force;
  Eigen::MatrixXd stiffness;
};

/// Of a cell that stands still.
EnergySlopes expect_slopes_of_energy(Alone& alone, const Points& free) {
  const Points still = Points::Zero(3, free.cols());
  const EnergySlopes found{alone.force(free, still).reshaped(), alone.second(free, still, true)};
  const Eigen::MatrixXd by_energy =
      slope_of([&](const Points& x) { return Eigen::VectorXd::Constant(1, alone.potential(x, still)); }, free, 1e-8);
  EXPECT_LT(largest(by_energy.transpose() + found.force), 1e-6 * largest(found.force));
  const Eigen::MatrixXd by_force =
      slope_of([&](const Points& x) -> Eigen::VectorXd { return alone.force(x, still).reshaped(); }, free, 1e-8);
  EXPECT_LT(largest(by_force + found.stiffness), 1e-5 * largest(found.stiffness));
  return found;
}

const std::vector<EffectSpec> stored{Stretch{}, Bend{}, Contact{}};

/// By the control points and by the two periods.
TEST(PeriodicCell, HasTheSlopesOfItsEnergyByAllThatMayMove) {
  const OneThread one;
  for (const auto& picture : repeats)
    for (const EffectSpec& spec : stored) {
      SCOPED_TRACE(picture[0] + " " + std::to_string(spec.index()));
      const Cell cell(picture, 1);
      Alone alone(cell, spec);
      const EnergySlopes found = expect_slopes_of_energy(alone, cell.free);
      EXPECT_GT(largest(found.stiffness.rightCols(6)), 0) << "nothing depends on the periods";
    }
}

const std::vector<Curls> both_ways{Curls::about_courses, Curls::about_wales};

TEST(PeriodicCell, HasTheSlopesOfItsEnergyWhenItIsBent) {
  const OneThread one;
  for (const auto& picture : repeats)
    for (const Curls curls : both_ways)
      for (const double curvature : {1e-3, 150.0, -150.0})
        for (const EffectSpec& spec : stored) {
          SCOPED_TRACE(picture[0] + " " + std::to_string(curvature) + " " + std::to_string(spec.index()) + " " +
                       std::to_string(static_cast<int>(curls)));
          const Cell cell(picture, 1, curls, curvature);
          Alone alone(cell, spec);
          const EnergySlopes found = expect_slopes_of_energy(alone, cell.free);
          if (!std::holds_alternative<Contact>(spec)) continue;
          EXPECT_GT(std::abs(found.force[found.force.size() - 1]), 1e-5 * largest(found.force))
              << "nothing depends on the curvature";
        }
}

/// Answers the damping.
Eigen::MatrixXd expect_slopes_of_loss(Alone& alone, const Points& free, const Points& velocity) {
  const Eigen::VectorXd force = alone.force(free, velocity).reshaped();
  const Eigen::MatrixXd by_loss =
      slope_of([&](const Points& v) { return Eigen::VectorXd::Constant(1, alone.potential(free, v)); }, velocity, 1e-5);
  EXPECT_LT(largest(by_loss.transpose() + force), 1e-6 * largest(force));
  Eigen::MatrixXd damping = alone.second(free, velocity, false);
  const Eigen::MatrixXd by_force =
      slope_of([&](const Points& v) -> Eigen::VectorXd { return alone.force(free, v).reshaped(); }, velocity, 1e-5);
  EXPECT_LT(largest(by_force + damping), 1e-5 * largest(damping));
  return damping;
}

TEST(PeriodicCell, RubsAsItBends) {
  const OneThread one;
  for (const auto& picture : repeats)
    for (const Curls curls : both_ways) {
      const Cell cell(picture, 1, curls, 150);
      Points velocity = Points::Zero(3, cell.free.cols());
      shake(velocity, 0.1, 8);
      Alone alone(cell, Friction{.threshold = 1});
      const Eigen::MatrixXd damping = expect_slopes_of_loss(alone, cell.free, velocity);
      EXPECT_GT(largest(damping.rightCols(1)), 0) << "nothing depends on how it bends";
    }
}

TEST(PeriodicCell, RubsNotAsItSlidesAlongItsAxis) {
  for (const Curls curls : both_ways) {
    const Cell cell({"kp", "pk"}, 1, curls, 150);
    Points velocity = Points::Zero(3, cell.free.cols()), shaken = velocity;
    velocity.leftCols(velocity.cols() - 2).row(curls == Curls::about_courses ? 0 : 1).setConstant(1e-3);
    shake(shaken, 1e-3, 8);
    Alone alone(cell, Friction{.threshold = 1});
    EXPECT_LT(largest(alone.force(cell.free, velocity)), 1e-10 * largest(alone.force(cell.free, shaken)));
  }
}

TEST(PeriodicCell, RubsAsItsPeriodsMove) {
  const OneThread one;
  for (const auto& picture : repeats)
    for (const double threshold : {1.0, 1e-2}) {
      SCOPED_TRACE(picture[0] + " " + std::to_string(threshold));
      const Cell cell(picture, -1);
      Points velocity = Points::Zero(3, cell.free.cols());
      shake(velocity, 0.1, 8);
      Alone alone(cell, Friction{.threshold = threshold});
      const Eigen::MatrixXd damping = expect_slopes_of_loss(alone, cell.free, velocity);
      EXPECT_GT(largest(damping.rightCols(6)), 0) << "nothing depends on how the periods move";
    }
}

/// The air flows with the periods: what only does that feels none.
TEST(PeriodicCell, IsDraggedByHowItMovesBesideItsPeriods) {
  const OneThread one;
  const Cell cell({"kp", "pk"}, 1);
  Points velocity = Points::Zero(3, cell.free.cols());
  shake(velocity, 0.1, 8);
  velocity.rightCols<2>().row(2).setZero();
  velocity(1, velocity.cols() - 2) = 0;
  Alone alone(cell, Drag{});
  const Eigen::VectorXd force = alone.force(cell.free, velocity).reshaped();
  const Eigen::MatrixXd by_loss = slope_of(
      [&](const Points& v) { return Eigen::VectorXd::Constant(1, alone.potential(cell.free, v)); }, velocity, 1e-5);
  EXPECT_LT(largest(by_loss.transpose() + force), 1e-6 * largest(force));
  const Eigen::Matrix2d periods = cell.free.topRightCorner<2, 2>(), rate = velocity.topRightCorner<2, 2>();
  Points flowing = Points::Zero(3, cell.free.cols());
  flowing.topRows<2>() = rate * periods.inverse() * cell.free.topRows<2>();
  EXPECT_LT(largest(alone.force(cell.free, flowing)), 1e-12 * largest(force));
}

struct Told {
  std::array<double, 3> energies{};
  Points force;  ///< on what may move
};

Told told(const Cell& cell, const Points& free) {
  const Points q = cell.q(free);
  const State at = state_of(q, Points::Zero(3, q.cols()));
  World world(cell.fabric, {Stretch{}, Bend{}, Contact{}}, Schedule(1.0), at);
  world.prepare(at);
  Told all;
  Points force = Points::Zero(3, q.cols());
  for (std::size_t i = 0; i < 3; ++i) {
    Load load{.energy = &all.energies[i], .force = &force};
    world.effects()[i]->add(at, load);
  }
  all.force = world.ties().gather(force);
  return all;
}

void expect_same(const Told& a, const Told& b) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a.energies[i], b.energies[i], 1e-11 * b.energies[i]);
  EXPECT_LT(largest(a.force - b.force), 1e-10 * largest(b.force));
}

/// Turned about its axis, and with a course that is said to be a repeat further around.
TEST(PeriodicCell, IsTheSameWhereverItLiesAroundItsAxis) {
  const double curvature = 150;
  const Cell cell({"kp", "pk"}, 0, Curls::about_courses, curvature);
  const Eigen::Index periods = cell.free.cols() - 2;
  const Told before = told(cell, cell.free);
  const Image around(*cell.fabric.cell, cell.free.rightCols<2>(), {0, 1});
  Points turned = cell.free, further = cell.free;
  for (Eigen::Index i = 0; i < periods; ++i) turned.col(i) = around(cell.free.col(i));
  const Yarn& yarn = cell.fabric.yarns[1];
  const int first = cell.ties.free_column(yarn.first_point);
  further.middleCols(first, yarn.segments) = turned.middleCols(first, yarn.segments);
  for (const Points& moved : {turned, further}) {
    const Told now = told(cell, moved);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(now.energies[i], before.energies[i], 1e-11 * before.energies[i]);
    const Points &there = now.force, &here = before.force;
    EXPECT_LT(largest(there.middleCols(first, yarn.segments) - around.turn() * here.middleCols(first, yarn.segments)),
              1e-10 * largest(here));
    EXPECT_NEAR(there(0, periods), here(0, periods), 1e-10 * largest(here));
  }
}

TEST(PeriodicCell, IsTheSameWhereverItLies) {
  const Cell cell({"kp", "pk"});
  Points moved = cell.free;
  moved.leftCols(moved.cols() - 2).colwise() += Vec3(7e-3, -3e-3, 0.4e-3);
  expect_same(told(cell, moved), told(cell, cell.free));
}

/// A point that is said to be a period further stays behind when the period grows: what it bears is taken from that of
/// the period.
TEST(PeriodicCell, IsTheSameIfACourseIsAWholePeriodFurther) {
  const Cell cell({"kp", "pk"});
  const Eigen::Index course = cell.free.cols() - 2;
  const Yarn& yarn = cell.fabric.yarns[1];
  const int first = cell.ties.free_column(yarn.first_point);
  for (const int by : {1, -1}) {
    Points moved = cell.free;
    moved.middleCols(first, yarn.segments).colwise() += by * Vec3(cell.free.col(course));
    Told expected = told(cell, cell.free);
    expected.force.col(course) -= by * expected.force.middleCols(first, yarn.segments).rowwise().sum();
    expect_same(told(cell, moved), expected);
  }
}

TEST(PeriodicCell, IsTheSameIfItsWalePeriodLeadsFurther) {
  const Cell cell({"kp", "pk"});
  const Eigen::Index course = cell.free.cols() - 2;
  for (const int by : {1, -1}) {
    Points leaning = cell.free;
    leaning.col(course + 1) += by * cell.free.col(course);
    Told expected = told(cell, cell.free);
    expected.force.col(course) -= by * expected.force.col(course + 1);
    expect_same(told(cell, leaning), expected);
  }
}

/// Segments are alike, but for the stitch they belong to.
TEST(PeriodicCell, IsTheSameWhereverACourseBegins) {
  const Cell cell({"kk", "kk"});
  const Eigen::Index course = cell.free.cols() - 2;
  const Told before = told(cell, cell.free);
  for (const int later : {1, 9, 13}) {
    SCOPED_TRACE(later);
    Points moved = cell.free;
    Told expected = before;
    for (const Yarn& yarn : cell.fabric.yarns) {
      const int first = cell.ties.free_column(yarn.first_point);
      for (int k = 0; k < yarn.segments; ++k) {
        const int from = first + (k + later) % yarn.segments;
        moved.col(first + k) = cell.free.col(from);
        expected.force.col(first + k) = before.force.col(from);
        if (k + later < yarn.segments) continue;
        moved.col(first + k) += cell.free.col(course);
        expected.force.col(course) -= before.force.col(from);
      }
    }
    expect_same(told(cell, moved), expected);
  }
}

}  // namespace
}  // namespace wale
