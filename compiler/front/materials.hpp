/// Yarn materials: presets by name, and maps of measured quantities.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/yaml.hpp"
#include "sim/fabric.hpp"

namespace wale {

/// The radius that Ding et al. 2023, Table 1, prints: EA and EI were measured as moduli on it, m.
inline constexpr double printed_radius = 0.524e-3;

/// "acrylic_16_2" or "paper-as-printed"; nothing for any other name.
std::optional<Material> material_preset(std::string_view name);
const std::vector<std::string_view>& material_preset_names();

/// A preset's name, or a map of quantities over a preset (`preset:`, acrylic_16_2 if absent). `name` is what a map is
/// called if it has no `name:` itself.
std::optional<Material> read_material(const YamlNode&, const std::string& name, Diagnostics&);

}  // namespace wale
