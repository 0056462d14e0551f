#include "bench/peers/comparison.hpp"

#include <cmath>
#include <functional>
#include <stdexcept>

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

std::vector<Method> movers() {
  const auto ours = [](World& world, const State& start, double until, double tolerance) {
    return move_by_runge_kutta(world, start, until, accuracy(tolerance));
  };
  const auto bdf = [](World& world, const State& start, double until, double tolerance) {
    return move_by_cvode(world, start, until, accuracy(tolerance));
  };
  return {{"wale `runge_kutta` 4(3)", ours, {1e-3, 1e-5}},         by_pair("Zonneveld 4(3)", Pair::zonneveld_43),
          by_pair("Sayfy-Aburub 4(3)", Pair::sayfy_aburub_43),     by_pair("Cash-Karp 5(4)", Pair::cash_karp_54),
          by_pair("Dormand-Prince 5(4)", Pair::dormand_prince_54), {"CVODE BDF", bdf, {1e-2, 1e-3, 1e-4, 1e-5}}};
}

std::vector<Method> resters(int samples) {
  const auto ours = [samples](World& world, const State& start, double until, double tolerance) {
    return rest_by_quasi_static(world, start, until, {.tolerance = tolerance, .samples = samples});
  };
  const auto kinsol = [samples](World& world, const State& start, double until, double tolerance) {
    return rest_by_kinsol(world, start, until, {.tolerance = tolerance, .samples = samples});
  };
  return {{"wale `quasi_static`", ours, {0.3, 0.1, 0.05}}, {"KINSOL", kinsol, {0.3, 0.1, 0.05}}};
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
  for (const Method& method : resters(samples))
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

}  // namespace wale::peers
