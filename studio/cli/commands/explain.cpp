#include <fmt/core.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "compiler/codes.hpp"
#include "studio/cli/commands.hpp"
#include "studio/cli/complain.hpp"
#include "studio/cli/exit_code.hpp"
#include "studio/cli/report.hpp"

namespace wale {
namespace {

int explain(const std::string& code, bool json) {
  const CodeInfo* info = find_code(code);
  if (!info) return complain(code, "no diagnostic has this code", "`wale explain` alone lists all");
  if (json) {
    const nlohmann::ordered_json object = {{"code", info->code},
                                           {"severity", name_of(info->severity)},
                                           {"meaning", info->meaning},
                                           {"example", info->fix}};
    fmt::print("{}", dump(object));
  } else {
    fmt::print("{} ({}): {}\n\nWrite, for example:\n\n{}\n", info->code, name_of(info->severity), info->meaning,
               info->fix);
  }
  return success;
}

int list(bool json) {
  nlohmann::ordered_json codes = nlohmann::ordered_json::array();
  for (const CodeInfo& info : code_table) {
    if (!json) fmt::print("{}  {:<8} {}\n", info.code, name_of(info.severity), info.meaning);
    codes.push_back({{"code", info.code}, {"severity", name_of(info.severity)}, {"meaning", info.meaning}});
  }
  if (json) fmt::print("{}", dump(nlohmann::ordered_json{{"codes", codes}}));
  return success;
}

}  // namespace

void add_explain(CLI::App& app, int& exit_code) {
  auto code = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  CLI::App* command = app.add_subcommand("explain", "Says what a diagnostic means; without CODE, lists all");
  command->add_option("CODE", *code, "As printed in brackets, like C003");
  command->add_flag("--json", *json, "Print one JSON object");
  command->callback([=, &exit_code] { exit_code = code->empty() ? list(*json) : explain(*code, *json); });
}

}  // namespace wale
