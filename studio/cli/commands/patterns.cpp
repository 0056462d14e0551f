#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <vector>

#include "studio/cli/commands.hpp"
#include "studio/cli/complain.hpp"
#include "studio/cli/exit_code.hpp"
#include "studio/cli/input.hpp"
#include "studio/cli/report.hpp"

namespace wale {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::vector<fs::path> library() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(WALE_PATTERNS)) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

Json describe(const fs::path& file) {
  Sources sources;
  Diagnostics say;
  const Source* source = read_or_complain(sources, file.string());
  const auto chart = source ? passes::parse_chart(*source, {}, say) : std::nullopt;
  print_all(say);
  Json entry = {{"name", file.stem().string()}, {"path", file.string()}};
  if (chart)
    entry.update({{"wales", chart->wales()}, {"courses", chart->course_count()}, {"description", chart->name}});
  return entry;
}

int list(bool json) {
  Json entries = Json::array();
  for (const fs::path& file : library()) entries.push_back(describe(file));
  if (json) fmt::print("{}", dump(Json{{"patterns", entries}}));
  for (const Json& each : entries) {
    if (json || !each.contains("wales")) continue;
    fmt::print("{:<24} {:>4} x {:<4} {}\n", each["name"].get<std::string>(), each["wales"].get<int>(),
               each["courses"].get<int>(), each["description"].get<std::string>());
  }
  return success;
}

int show(const std::string& name) {
  for (const fs::path& file : library()) {
    if (file.stem() != name) continue;
    Sources sources;
    const Source* source = read_or_complain(sources, file.string());
    if (source) fmt::print("{}", source->text);
    return source ? success : bad_input;
  }
  return complain(name, "the library has no pattern of this name", "`wale patterns` lists them");
}

}  // namespace

void add_patterns(CLI::App& app, int& exit_code) {
  auto name = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  CLI::App* command =
      app.add_subcommand("patterns", "Lists the built-in library (wales x courses), or prints one pattern");
  command->add_option("NAME", *name, "Print this pattern's text");
  command->add_flag("--json", *json, "Print one JSON object");
  command->callback([=, &exit_code] { exit_code = name->empty() ? list(*json) : show(*name); });
}

}  // namespace wale
