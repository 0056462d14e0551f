#include "compiler/front/materials.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "compiler/fields.hpp"
#include "compiler/front/limits.hpp"

namespace wale {
namespace {

double circle_area(double radius) { return std::numbers::pi * radius * radius; }
double circle_second_moment(double radius) { return std::numbers::pi / 4 * std::pow(radius, 4); }

/// Table 1 of Ding et al. 2023 taken at its word: the radius as contact radius, E_b = 2.49e4 g/(cm s²).
/// The contact stiffness is not printed; 1e4 N/m is ours, enough to keep yarns apart at moderate loads.
Material paper_as_printed() {
  Material material;
  material.name = "paper-as-printed";
  material.bending_rigidity = 2490 * circle_second_moment(printed_radius);
  material.diameter = 2 * printed_radius;
  material.law = ContactLaw::quadratic;
  material.contact_stiffness = 1e4;
  return material;
}

constexpr Range densities{1e-9, 1}, stiffnesses{1e-6, 1e7}, rigidities{1e-18, 1}, moduli{1, 1e13},
    contact_stiffnesses{1e-6, 1e9}, radii{limits::least_diameter / 2, limits::most_diameter / 2},
    diameters{limits::least_diameter, limits::most_diameter}, exponents{2.000001, 20};

class MaterialReader {
 public:
  MaterialReader(const YamlNode& node, Material base, Diagnostics& say)
      : node_(node),
        fields_(node, "a material",
                {"preset", "name", "linear_density", "axial_stiffness", "bending_rigidity", "contact_diameter",
                 "stretch_modulus", "bend_modulus", "radius", "E_stretch", "E_bend", "contact"},
                say),
        material_(std::move(base)),
        say_(say) {}

  std::optional<Material> read() {
    if (!fields_.is_map()) return std::nullopt;
    if (const YamlNode* name = fields_.find("name")) {
      if (const auto text = read_text(*name, "a material's name", say_)) material_.name = *text;
    }
    set("linear_density", dimensions::linear_density, densities, material_.linear_density);
    set("contact_diameter", dimensions::length, diameters, material_.diameter);
    read_section();
    read_contact();
    return material_;
  }

 private:
  void set(std::string_view key, const Dimension& dimension, Range range, double& value) {
    const YamlNode* given = fields_.find(key);
    if (!given) return;
    if (const auto read = read_quantity(*given, fmt::format("\"{}\"", key), dimension, range, say_)) value = *read;
  }

  /// EA and EI, of which each is given at most once: as such, or as a modulus on a circle.
  void read_section() {
    const std::optional<double> radius = read_radius();
    set_stiffness({"axial_stiffness", "stretch_modulus", "E_stretch"}, dimensions::force, stiffnesses, circle_area,
                  radius, material_.axial_stiffness);
    set_stiffness({"bending_rigidity", "bend_modulus", "E_bend"}, dimensions::bending_rigidity, rigidities,
                  circle_second_moment, radius, material_.bending_rigidity);
  }

  std::optional<double> read_radius() {
    const YamlNode* given = fields_.find("radius");
    if (!given) return std::nullopt;
    if (!fields_.find("stretch_modulus") && !fields_.find("bend_modulus")) {
      say_.error("M002", given->span, "\"radius\" has no use here",
                 "a radius turns `stretch_modulus` and `bend_modulus` into stiffnesses; touching is ruled by "
                 "`contact_diameter`");
    }
    return read_quantity(*given, "\"radius\"", dimensions::length, radii, say_);
  }

  void set_stiffness(const std::array<std::string_view, 3>& keys, const Dimension& dimension, Range range,
                     double (*section)(double), std::optional<double> radius, double& value) {
    const YamlNode* chosen = nullptr;
    for (const std::string_view key : keys) {
      const YamlNode* given = fields_.find(key);
      if (!given) continue;
      if (chosen) {
        say_.error("M002", given->span, fmt::format("\"{}\" says again what another key has said", key),
                   fmt::format("keep one of {}, {} and {}", keys[0], keys[1], keys[2]));
        continue;
      }
      chosen = given;
      if (key == keys[0]) {
        set(key, dimension, range, value);
        continue;
      }
      const auto modulus = read_quantity(*given, fmt::format("\"{}\"", key), dimensions::stress, moduli, say_);
      const bool on_printed_radius = key == keys[2];
      if (!on_printed_radius && !fields_.find("radius")) {
        say_.error("M002", given->span, fmt::format("\"{}\" needs the radius of the yarn that it was measured on", key),
                   fmt::format("add `radius: 0.524 mm`, or give `{}`", keys[0]));
      } else if (modulus && (on_printed_radius || radius)) {
        value = *modulus * section(on_printed_radius ? printed_radius : *radius);
      }
    }
  }

  void read_contact() {
    const YamlNode* given = fields_.find("contact");
    if (!given) return;
    const Fields contact(*given, "a material's contact", {"law", "stiffness", "core_diameter", "exponent"}, say_);
    if (const YamlNode* law = contact.find("law")) {
      const auto word = read_word(*law, "a contact law", {contact_law_names.begin(), contact_law_names.end()}, say_);
      if (word) material_.law = ContactLaw{static_cast<std::uint8_t>(*word)};
    }
    set_of(contact, "stiffness", dimensions::stiffness, contact_stiffnesses, material_.contact_stiffness);
    set_of(contact, "core_diameter", dimensions::length, diameters, material_.core_diameter);
    set_of(contact, "exponent", dimensions::ratio, exponents, material_.shell_exponent);
    check_core(contact);
  }

  void set_of(const Fields& fields, std::string_view key, const Dimension& dimension, Range range, double& value) {
    const YamlNode* given = fields.find(key);
    if (!given) return;
    if (const auto read = read_quantity(*given, fmt::format("\"{}\"", key), dimension, range, say_)) value = *read;
  }

  void check_core(const Fields& contact) {
    const bool core_shell = material_.law == ContactLaw::core_shell;
    for (const std::string_view key : {"core_diameter", "exponent"}) {
      const YamlNode* given = contact.find(key);
      if (given && !core_shell) {
        say_.error("M002", given->span, fmt::format("\"{}\" has no use here", key), "it belongs to `law: core_shell`");
      }
    }
    if (core_shell && material_.core_diameter >= material_.diameter) {
      const YamlNode* given = contact.find("core_diameter");
      say_.error("M002", given ? given->span : node_.span,
                 fmt::format("the core ({:g} mm) is not thinner than the yarn ({:g} mm)", material_.core_diameter * 1e3,
                             material_.diameter * 1e3),
                 "make `core_diameter` less than `contact_diameter`");
    }
  }

  const YamlNode& node_;
  Fields fields_;
  Material material_;
  Diagnostics& say_;
};

std::optional<Material> find_preset(const YamlNode& node, Diagnostics& say) {
  const auto name = read_text(node, "a material's name", say);
  if (!name) return std::nullopt;
  std::optional<Material> preset = material_preset(*name);
  if (!preset) {
    say.error("M001", node.span, fmt::format("nobody has defined a material \"{}\"", *name),
              suggest(*name, material_preset_names()));
  }
  return preset;
}

}  // namespace

std::optional<Material> material_preset(std::string_view name) {
  if (name == "acrylic_16_2") return Material{};
  if (name == "paper-as-printed") return paper_as_printed();
  return std::nullopt;
}

const std::vector<std::string_view>& material_preset_names() {
  static const std::vector<std::string_view> names{"acrylic_16_2", "paper-as-printed"};
  return names;
}

std::optional<Material> read_material(const YamlNode& node, const std::string& name, Diagnostics& say) {
  if (node.kind == YamlNode::Kind::scalar) return find_preset(node, say);
  Material base;
  if (const YamlNode* preset = node.find("preset")) base = find_preset(*preset, say).value_or(base);
  base.name = name;
  return MaterialReader(node, std::move(base), say).read();
}

}  // namespace wale
