#include "compiler/yarn_materials.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/front/materials.hpp"
#include "compiler/spelling.hpp"

namespace wale {
namespace {

/// The material that one of the words of a header names; people write colours and counts there too.
std::optional<Material> named_in(std::string_view text) {
  constexpr std::string_view between = " \t,;";
  for (std::size_t at = text.find_first_not_of(between); at != text.npos;) {
    const std::size_t end = std::min(text.find_first_of(between, at), text.size());
    if (auto known = material_preset(text.substr(at, end - at))) return known;
    at = text.find_first_not_of(between, end);
  }
  return std::nullopt;
}

}  // namespace

std::vector<Material> default_materials(const Program& program) {
  std::vector<Material> materials;
  for (const std::string& carrier : program.carriers) {
    const auto header = std::find_if(program.headers.begin(), program.headers.end(),
                                     [&](const Header& one) { return one.name == "Yarn-" + carrier; });
    const auto named = header == program.headers.end() ? std::nullopt : named_in(header->value);
    materials.push_back(named.value_or(Material{}));
  }
  return materials;
}

std::vector<Material> materials_of(const std::vector<std::string>& yarns, const YarnMaterials& given,
                                   std::vector<Material> assumed, std::string_view kind, Diagnostics& say) {
  std::vector<Material> materials =
      given.otherwise ? std::vector<Material>(yarns.size(), *given.otherwise) : std::move(assumed);
  for (const YarnMaterials::Named& named : given.by_name) {
    const auto yarn = std::find(yarns.begin(), yarns.end(), named.yarn);
    if (yarn != yarns.end())
      materials[static_cast<std::size_t>(yarn - yarns.begin())] = named.material;
    else
      say.error("S009", named.span, fmt::format("the pattern has no {} \"{}\"", kind, named.yarn),
                suggest(named.yarn, {yarns.begin(), yarns.end()}));
  }
  return materials;
}

}  // namespace wale
