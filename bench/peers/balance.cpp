#include "bench/peers/balance.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace wale::peers {
namespace {

constexpr double never_through = 0.1;  // of the diameter, between two yarns
constexpr double flat = 1e-9;          // of the largest eigenvalue: what a free shift of the fabric is rounded to

}  // namespace

Balance::Balance(World& world, State from)
    : world_(world),
      increment_(world),
      leeway_(world.fabric()),
      from_(std::move(from)),
      exact_(increment_.points()),
      convex_(increment_.points()) {}

void Balance::load(double t) {
  from_.t = t;
  if (const auto& cell = world_.fabric().cell) world_.guide().lead(*cell, from_);
}

State Balance::at(const ConstVector& x) const {
  State state = from_;
  state.q += increment_.spread(x.reshaped(3, increment_.points()));
  return state;
}

bool Balance::force(const ConstVector& x, Vector f) {
  ++evaluations_;
  increment_.value(at(x), &force_);
  f = force_.reshaped();
  return force_.allFinite() && world_.closest() > never_through;
}

double Balance::residual(const ConstVector& f) {
  return std::sqrt(f.reshaped(3, f.size() / 3).colwise().squaredNorm().maxCoeff());
}

void Balance::assemble(const ConstVector& x) {
  const State state = at(x);
  increment_.prepare(state);
  increment_.second(state, leeway_, {}, Increment::Model::exact, exact_);
  increment_.second(state, leeway_, {}, Increment::Model::convex, convex_);
}

bool Balance::factor(double shift) {
  ++factorizations_;
  return cholesky_.factor(convex_, shift);
}

void Balance::solve(Vector v) const {
  Eigen::VectorXd x = v;
  cholesky_.solve(x);
  v = x;
}

void Balance::multiply(const ConstVector& v, Vector out) const {
  Eigen::VectorXd product;
  exact_.multiply(v, product);
  out = product;
}

int Balance::ways_down() const {
  const Eigen::Index n = 3 * increment_.points();
  Eigen::MatrixXd dense(n, n);
  for (Eigen::Index i = 0; i < n; ++i) multiply(Eigen::VectorXd::Unit(n, i), dense.col(i));
  const Eigen::VectorXd curvatures =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dense, Eigen::EigenvaluesOnly).eigenvalues();
  return static_cast<int>((curvatures.array() < -flat * curvatures.maxCoeff()).count());
}

void Balance::conclude(Answer& answer, const Stopwatch& watch) const {
  answer.state = from_;
  answer.evaluations = evaluations_;
  answer.factorizations = factorizations_;
  answer.processor = watch.processor();
  answer.wall = watch.wall();
}

}  // namespace wale::peers
