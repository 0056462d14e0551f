/// Climbs every hard case of tests/stability until something breaks, with each solver and each law of contact, and
/// prints a Markdown table of how far they came; see docs/stability.md.
#include <fmt/format.h>
#include <omp.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "tests/stability/trial.hpp"

namespace wale::stability {
namespace {

struct Options {
  std::string only, solver, law;
  double seconds = 60;
  bool every_rung = false;
};

bool has(const std::string& name, const std::string& part) { return name.find(part) != std::string::npos; }

std::string rung_name(const HardCase& of, double rung) { return fmt::format("{:g} {}", rung, of.unit); }

/// The last rung that holds, and the first that does not, with the reason.
std::string climb(const HardCase& of, SolverKind kind, ContactLaw law, const Options& options) {
  std::string last = "none";
  for (const double rung : of.ladder) {
    const HardScene hard = hard_scene(of, rung, kind, law);
    Results results;
    const Verdict verdict = attempt(hard, results, {.seconds = options.seconds});
    if (options.every_rung)
      fmt::print(stderr, "{}, {}, {}, {}: {} ({} steps)\n", of.name, name_of(kind), name_of(law), rung_name(of, rung),
                 verdict.held() ? "held" : verdict.what, results.effort.accepted);
    if (!verdict.held()) {
      const char* how[] = {"", "gave up: ", "broke: ", ""};
      return fmt::format("{} | {} | {}{}", last, rung_name(of, rung), how[static_cast<int>(verdict.end)], verdict.what);
    }
    last = rung_name(of, rung);
  }
  return last + " | |";
}

void climb_all(const Options& options) {
  fmt::print(
      "| case | solver | contact | last that holds | first that does not | what happens "
      "|\n|---|---|---|---|---|---|\n");
  for (const HardCase& of : hard_cases()) {
    if (!has(of.name, options.only)) continue;
    for (const SolverKind kind : of.solvers)
      for (const ContactLaw law : {ContactLaw::barrier, ContactLaw::quadratic, ContactLaw::core_shell}) {
        if (!has(name_of(kind), options.solver) || !has(name_of(law), options.law)) continue;
        fmt::print("| {} | {} | {} | {} |\n", of.name, name_of(kind), name_of(law), climb(of, kind, law, options));
        std::fflush(stdout);
      }
  }
}

}  // namespace
}  // namespace wale::stability

int main(int count, char** arguments) {
  wale::stability::Options options;
  CLI::App app("Climbs the hard cases of tests/stability until something breaks");
  app.add_option("--only", options.only, "Only cases with this in their name");
  app.add_option("--solver", options.solver, "Only by solvers with this in their name");
  app.add_option("--law", options.law, "Only with laws of contact with this in their name");
  app.add_option("--seconds", options.seconds, "Stop a run after so long");
  app.add_flag("--every-rung", options.every_rung, "Say on stderr how each rung ends");
  CLI11_PARSE(app, count, arguments);
  omp_set_num_threads(1);
  wale::stability::climb_all(options);
}
