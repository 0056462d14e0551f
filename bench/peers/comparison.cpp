#include "bench/peers/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "bench/peers/balance.hpp"
#include "bench/peers/markdown.hpp"
#include "bench/peers/methods.hpp"

namespace wale::peers {
namespace {

struct Method {
  std::string name;
  std::function<Answer(World&, const State&, double until, double tolerance)> solve;
  std::vector<double> tolerances;
};

Accuracy accuracy(double relative) {
  return {.relative = relative, .absolute = 1e-4 * relative, .absolute_speed = 1e-4 * relative};
}

Method by_pair(const std::string& name, Pair pair) {
  return {"ARKODE " + name,
          [pair](World& world, const State& start, double until, double tolerance) {
            return move_by_arkode(world, start, until, accuracy(tolerance), pair);
          },
          {1e-3, 1e-5}};
}

Method by_runge_kutta(const std::string& name, RungeKutta::Method method) {
  return {"wale " + name,
          [method](World& world, const State& start, double until, double tolerance) {
            return move_by_runge_kutta(world, start, until, accuracy(tolerance), method);
          },
          {1e-3, 1e-4, 1e-5, 1e-6}};
}

std::vector<Method> movers() {
  const auto bdf = [](World& world, const State& start, double until, double tolerance) {
    return move_by_cvode(world, start, until, accuracy(tolerance));
  };
  return {by_runge_kutta("`kutta` 4(3)", RungeKutta::Method::kutta),
          by_runge_kutta("`dormand_prince` 5(4)", RungeKutta::Method::dormand_prince),
          by_pair("Zonneveld 4(3)", Pair::zonneveld_43),
          by_pair("Sayfy-Aburub 4(3)", Pair::sayfy_aburub_43),
          by_pair("Cash-Karp 5(4)", Pair::cash_karp_54),
          by_pair("Dormand-Prince 5(4)", Pair::dormand_prince_54),
          {"CVODE BDF", bdf, {1e-2, 1e-3, 1e-4, 1e-5}}};
}

std::vector<Method> resters(int samples, std::vector<double> tolerances) {
  const auto ours = [samples](World& world, const State& start, double until, double tolerance) {
    return rest_by_quasi_static(world, start, until, {.tolerance = tolerance, .samples = samples});
  };
  const auto kinsol = [samples](World& world, const State& start, double until, double tolerance) {
    return rest_by_kinsol(world, start, until, {.tolerance = tolerance, .samples = samples});
  };
  const auto flow = [samples](World& world, const State& start, double until, double tolerance) {
    return rest_by_flow(world, start, until, {.tolerance = tolerance, .samples = samples});
  };
  return {
      {"wale `quasi_static`", ours, tolerances}, {"KINSOL", kinsol, tolerances}, {"CVODE, x' = f", flow, tolerances}};
}

/// What a problem asks for at even samples of its load, as far as a method gets, and what that cost.
struct Curve {
  std::vector<double> values;
  Answer answer;
};

Curve curve_by(const Method& method, double tolerance, World& world, const Problem& problem, int samples) {
  Curve curve;
  Answer& sum = curve.answer;
  sum.state = problem.start();
  for (int sample = 1; sample <= samples && sum.failure.empty(); ++sample) {
    const Answer one = method.solve(world, sum.state, problem.duration() * sample / samples, tolerance);
    sum.state = one.state;
    sum.steps += one.steps;
    sum.evaluations += one.evaluations;
    sum.factorizations += one.factorizations;
    sum.processor += one.processor;
    sum.wall += one.wall;
    sum.failure = one.failure;
    if (sum.failure.empty()) curve.values.push_back(problem.asked_of(one.state).value);
  }
  return curve;
}

/// What tells a least of the energy from a saddle.
struct End {
  double energy = 0;  // J
  int ways_down = 0;
};

End end_of(World& world, const State& state) {
  End end;
  Load load{.energy = &end.energy};
  world.prepare(state);
  world.evaluate(state, load);
  Balance balance(world, state);
  balance.assemble(Eigen::VectorXd::Zero(balance.size()));
  end.ways_down = balance.ways_down();
  return end;
}

/// The largest difference over the largest value, as far as `values` goes.
double largest_error(const std::vector<double>& values, const std::vector<double>& expected) {
  double most = 0, peak = 0;
  for (const double value : expected) peak = std::max(peak, std::abs(value));
  for (std::size_t i = 0; i < values.size(); ++i) most = std::max(most, std::abs(values[i] - expected[i]));
  return most / peak;
}

/// Root mean square of the distances between control points, m.
double distance(const Points& a, const Points& b) { return std::sqrt((a - b).colwise().squaredNorm().mean()); }

Row row(const Method& method, double tolerance, const std::string& error, const Answer& answer) {
  return {method.name,
          fmt::format("{:.0e}", tolerance),
          answer.failure.empty() ? error : fmt::format("{} at {:.3g} s", answer.failure, answer.state.t),
          fmt::format("{}", answer.steps),
          fmt::format("{}", answer.evaluations),
          fmt::format("{}", answer.factorizations),
          fmt::format("{:.2f}", answer.processor),
          fmt::format("{:.2f}", answer.wall)};
}

void print_title(const std::string& title, const Problem& problem, const char* error) {
  fmt::print("\n{}, {} unknowns\n\n", title, problem.start().q.size());
  print_heading({"method", "tolerance", error, "steps", "evaluations", "factors", "processor s", "wall s"});
}

}  // namespace

void compare_motion(const Problem& problem, const std::string& title, double span) {
  print_title(title, problem, "error of position, µm");
  const auto world = problem.moving();
  const Answer reference = move_by_arkode(*world, problem.start(), span, accuracy(1e-8), Pair::dormand_prince_54);
  for (const Method& method : movers())
    for (const double tolerance : method.tolerances) {
      const Answer answer = method.solve(*world, problem.start(), span, tolerance);
      print_row(
          row(method, tolerance, fmt::format("{:.2g}", 1e6 * distance(answer.state.q, reference.state.q)), answer));
    }
}

void compare_rest(const Problem& problem, const std::string& title, int samples) {
  const State& start = problem.start();
  const auto world = problem.still();
  Answer reference;
  for (const double tolerance : {0.01, 0.02, 0.05}) {
    reference = rest_by_quasi_static(*world, start, problem.duration(), {.tolerance = tolerance, .samples = samples});
    if (reference.failure.empty()) break;
  }
  if (!reference.failure.empty()) throw std::runtime_error(reference.failure);
  const Quantity expected = problem.asked_of(reference.state);
  const auto error = [&](const Answer& answer) {
    return fmt::format("{:.2g} %", 100 * (problem.asked_of(answer.state).value / expected.value - 1));
  };
  print_title(fmt::format("{}: {} {:.6g} {}", title, expected.name, expected.value, expected.unit), problem,
              "error of it");
  for (const Method& method : resters(samples, {0.3, 0.1, 0.05}))
    for (const double tolerance : method.tolerances) {
      const Answer answer = method.solve(*world, start, problem.duration(), tolerance);
      print_row(row(method, tolerance, error(answer), answer));
    }
  const Method bdf{"CVODE BDF, with drag", {}, {1e-2, 1e-3}};
  const auto moving = problem.moving();
  for (const double tolerance : bdf.tolerances) {
    const Answer answer =
        move_by_cvode(*moving, start, problem.duration(),
                      {.relative = tolerance, .absolute = 1e-5 * tolerance, .absolute_speed = 0.1 * tolerance});
    print_row(row(bdf, tolerance, error(answer), answer));
  }
}

void compare_curves(const Problem& problem, const std::string& title, int samples) {
  const std::vector<Method> methods = resters(1, {0.1, 0.01, 1e-3});
  const auto world = problem.still();
  const Curve reference = curve_by(methods.front(), 1e-5, *world, problem, samples);
  if (!reference.answer.failure.empty()) throw std::runtime_error(reference.answer.failure);
  const Quantity last = problem.asked_of(reference.answer.state);
  fmt::print("\n{}: {} {:.6g} {} at the end, {} unknowns\n\n", title, last.name, last.value, last.unit,
             Balance(*world, problem.start()).size());
  print_heading({"method", "tolerance", "error of the curve", "energy at the end, mJ", "ways down", "steps",
                 "evaluations", "factors", "processor s", "wall s"});
  for (const Method& method : methods)
    for (const double tolerance : method.tolerances) {
      const Curve curve = curve_by(method, tolerance, *world, problem, samples);
      const End end = end_of(*world, curve.answer.state);
      Row cells = row(method, tolerance, fmt::format("{:.2g} %", 100 * largest_error(curve.values, reference.values)),
                      curve.answer);
      cells.insert(cells.begin() + 3, {fmt::format("{:.6f}", 1e3 * end.energy), fmt::format("{}", end.ways_down)});
      print_row(cells);
    }
}

}  // namespace wale::peers
