#include <fmt/core.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "compiler/codes.hpp"
#include "studio/choice/report.hpp"
#include "studio/cli/commands.hpp"
#include "studio/cli/complain.hpp"
#include "studio/cli/exit_code.hpp"
#include "studio/cli/report.hpp"
#include "studio/cli/session.hpp"

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

/// Both what was decided and by what numbers, and nothing run.
int explain_scene(const std::string& path, bool json) {
  const auto session = begin_run(path, std::nullopt);
  if (!session) return bad_input;
  const Settled& settled = session->settled;
  if (json) {
    fmt::print("{}", choices_json(settled, Refining{}));
    return success;
  }
  fmt::print("{}", words_of(settled.scales));
  const std::string words = words_of(settled);
  fmt::print("{}", words.empty() ? "Nothing is left open: there is no `accuracy:` and no `effects: auto`\n" : words);
  return success;
}

bool names_a_scene(const std::string& word) { return word.ends_with(".yaml") || word.ends_with(".yml"); }

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
  CLI::App* command = app.add_subcommand(
      "explain", "Says what a diagnostic means, or what a scene leaves to wale and how it is decided");
  command->add_option("CODE|SCENE", *code,
                      "As printed in brackets, like C003, or a scene file; without, lists all codes");
  command->add_flag("--json", *json, "Print one JSON object");
  command->callback([=, &exit_code] {
    if (code->empty())
      exit_code = list(*json);
    else
      exit_code = names_a_scene(*code) ? explain_scene(*code, *json) : explain(*code, *json);
  });
}

}  // namespace wale
