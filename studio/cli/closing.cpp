#include "studio/cli/closing.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <iterator>

#include "sim/results/balance.hpp"
#include "sim/results/moments.hpp"
#include "sim/results/picture.hpp"
#include "studio/cli/complain.hpp"
#include "studio/cli/exit_code.hpp"

namespace wale {
namespace {

struct Leaving {
  const char *name, *use;
};
constexpr Leaving leavings[] = {{"curve.csv", "the stress-strain table"},
                                {"curve.svg", "the same as a picture"},
                                {"fabric_relaxed.svg", "the relaxed fabric, seen from its face"},
                                {"fabric_curl.svg", "the same, seen along the axis about which it curls"},
                                {"fabric_pulled.svg", "the pulled fabric, coloured by the stretch of its yarn"},
                                {"frames.pvd", "every saved state as tubes, for ParaView"},
                                {"results.h5", "every saved state, exactly; --resume reads it"},
                                {"choices.json", "what was chosen for the scene, and by which numbers"},
                                {"summary.json", "sizes, features of the curve, cost, warnings"}};

std::string sizes(const Sizes& relaxed) {
  constexpr double mm = 1e3;
  return fmt::format(
      "Relaxed: {:.1f} mm wide, {:.1f} mm long, {:.2f} mm thick; a wale each {:.2f} mm, a course each {:.2f} mm\n",
      mm * relaxed.width, mm * relaxed.length, mm * relaxed.thickness, mm * relaxed.wale_spacing,
      mm * relaxed.course_spacing);
}

std::string curl(double curvature) {
  constexpr double mm = 1e3, flat = 1;  // 1/m
  if (std::abs(curvature) < flat) return "Curl: none\n";
  return fmt::format("Curl: to a radius of {:.2f} mm, towards the {}\n", mm / std::abs(curvature),
                     curvature > 0 ? "face" : "back");
}

std::string balance_words(const Results& results) {
  constexpr double mN = 1e3;
  std::string text;
  for (const Balance& stage : balances(results)) {
    text += fmt::format("  {:<10} {:.3g} mN (asked for: {:.3g} mN)", stage.stage, mN * stage.residual,
                        mN * stage.tolerance);
    if (stage.load > 0)
      text += fmt::format(", {:.2g} % of the largest load on a {}, {:.3g} N", 100 * stage.share(),
                          stage.along == Along::wale ? "wale" : "course", stage.load);
    text += "\n";
  }
  return text.empty() ? text : "Residual force on a control point, at most:\n" + text;
}

}  // namespace

std::string closing_words(const Results& results, const std::string& folder) {
  fmt::memory_buffer text;
  auto out = std::back_inserter(text);
  const Curve curve = stress_strain(results);
  if (curve.strain.size() > 1) fmt::format_to(out, "{}\n", terminal_plot(curve));
  if (results.relaxed.length > 0) fmt::format_to(out, "{}", sizes(results.relaxed));
  if (const auto curvature = relaxed_curvature(results)) fmt::format_to(out, "{}", curl(*curvature));
  fmt::format_to(out, "Crossings: {} of {} in every saved state{}\n", results.topology.found, results.topology.expected,
                 results.topology.intact() ? "" : ": LOOPS CAME OUT, off an end of their yarn or through yarn");
  fmt::format_to(out, "{}", balance_words(results));
  fmt::format_to(out, "Took {:.1f} s. Results in {}:\n", total_seconds(results.phases), folder);
  for (const Leaving& each : leavings) {
    if (std::filesystem::exists(std::filesystem::path(folder) / each.name)) {
      fmt::format_to(out, "  {:<20} {}\n", each.name, each.use);
    }
  }
  return fmt::to_string(text);
}

int tell_outcome(const Results& results, Outcome outcome, const std::string& folder) {
  if (outcome == Outcome::finished) return success;
  if (outcome == Outcome::interrupted) {
    fmt::print(stderr, "Interrupted; go on with: wale run --resume {}\n", folder);
    return interrupted;
  }
  complain(folder, "the solve failed: " + results.effort.failure, "what was done until then is saved");
  return failed_solve;
}

}  // namespace wale
