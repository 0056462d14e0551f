#include "compiler/machines.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace wale {
namespace {

bool begins_with(std::string_view text, std::string_view lower_case) {
  return text.size() >= lower_case.size() &&
         std::equal(lower_case.begin(), lower_case.end(), text.begin(),
                    [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); });
}

constexpr std::array<Target, 2> targets{{{"kniterate", "Kniterate", 7, 6, false}, {"swg", "SWG091N2", 15, 10, true}}};

}  // namespace

MachineFacts machine_facts(std::string_view machine) {
  if (begins_with(machine, "swg")) return {8, 15, false};
  if (begins_with(machine, "kniterate")) return {2, 7, true};
  return {};
}

const Target* find_target(std::string_view name) {
  const auto found = std::find_if(targets.begin(), targets.end(), [&](const Target& one) { return one.name == name; });
  return found == targets.end() ? nullptr : &*found;
}

}  // namespace wale
