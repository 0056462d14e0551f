#include <fmt/core.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "sim/results/csv.hpp"
#include "sim/results/curves.hpp"
#include "sim/results/hdf5.hpp"
#include "studio/cli/commands.hpp"
#include "studio/cli/complain.hpp"
#include "studio/cli/exit_code.hpp"
#include "studio/cli/run_folder.hpp"

namespace wale {
namespace {

/// Of a pull its curve, of a deformation one object for each direction.
std::string curve_json(const Results& results) {
  nlohmann::ordered_json object{{"complete", results.complete}};
  for (const auto& [label, curve] : stress_strain_curves(results)) {
    nlohmann::ordered_json& in = label.empty() ? object : object[label];
    in["strain"] = curve.strain;
    in["stress_Pa"] = curve.stress;
    if (!label.empty()) continue;
    in["force_N"] = curve.force;
    in["force_per_wale_N"] = curve.force_per_wale;
  }
  return object.dump(2) + "\n";
}

int curve(const std::string& folder, bool json) {
  const Results results = read_hdf5((std::filesystem::path(folder) / results_name).string());
  if (strained_rows(results.samples).empty()) return complain(folder, "nothing was pulled or deformed in this run");
  fmt::print("{}", json ? curve_json(results) : curve_csv(results));
  return success;
}

}  // namespace

void add_curve(CLI::App& app, int& exit_code) {
  auto folder = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  CLI::App* command = app.add_subcommand("curve", "Prints the stress-strain table of a run");
  command->add_option("DIR", *folder, "The folder that `wale run` left")->required();
  command->add_flag("--json", *json, "Print one JSON object");
  command->callback([=, &exit_code] { exit_code = curve(*folder, *json); });
}

}  // namespace wale
