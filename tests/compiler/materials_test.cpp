#include "compiler/front/materials.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace wale {
namespace {

Material read(const std::string& text) {
  const Source source{"m.yaml", text};
  Diagnostics say;
  const auto root = parse_yaml(source, say);
  const auto material = root ? read_material(*root, "inline", say) : std::nullopt;
  for (const Diagnostic& one : say.all()) ADD_FAILURE() << print(one);
  return material.value_or(Material{});
}

TEST(Materials, TheDefaultIsTheCorrectedAcrylic) {
  EXPECT_EQ(material_preset("acrylic_16_2"), Material{});
  EXPECT_EQ(read("acrylic_16_2"), Material{});
  EXPECT_FALSE(material_preset("wool"));
}

TEST(Materials, EveryPresetIsListed) {
  for (const std::string_view name : material_preset_names()) EXPECT_EQ(material_preset(name)->name, name);
}

// 2.49e4 g/(cm s²) is 2490 Pa; π r⁴/4 of 0.524 mm is 5.9213e-14 m⁴.
TEST(Materials, ThePaperAsPrintedIsAHundredTimesSofterInBendingAndTwiceAsThick) {
  const Material paper = read("paper-as-printed");
  EXPECT_NEAR(paper.bending_rigidity, 1.4744e-10, 1e-13);
  EXPECT_DOUBLE_EQ(paper.diameter, 1.048e-3);
  EXPECT_EQ(paper.law, ContactLaw::quadratic);
  EXPECT_DOUBLE_EQ(paper.axial_stiffness, Material{}.axial_stiffness);
}

TEST(Materials, ModuliOnThePrintedRadiusGiveTheMeasuredStiffnesses) {
  const Material material = read("{E_stretch: 79 MPa, E_bend: 0.249 MPa}");
  EXPECT_NEAR(material.axial_stiffness, 68.1, 0.05);
  EXPECT_NEAR(material.bending_rigidity, 1.474e-8, 1e-11);
  EXPECT_EQ(material.name, "inline");
  EXPECT_DOUBLE_EQ(material.diameter, Material{}.diameter);
}

TEST(Materials, ModuliTakeTheRadiusThatIsGiven) {
  const Material material =
      read("{stretch_modulus: 1 GPa, bend_modulus: 2 GPa, radius: 0.1 mm, contact_diameter: 0.3 mm}");
  EXPECT_NEAR(material.axial_stiffness, std::numbers::pi * 10, 1e-9);
  EXPECT_NEAR(material.bending_rigidity, 2e9 * std::numbers::pi / 4 * 1e-16, 1e-18);
  EXPECT_DOUBLE_EQ(material.diameter, 0.3e-3);
}

TEST(Materials, AMapChangesItsPreset) {
  const Material material = read(
      "{preset: paper-as-printed, name: soft, linear_density: 30 tex, axial_stiffness: 10 N, bending_rigidity: 2e-9 N "
      "m^2,"
      " contact: {law: core_shell, stiffness: 12 N/m, core_diameter: 0.4 mm, exponent: 3}}");
  EXPECT_EQ(material.name, "soft");
  EXPECT_DOUBLE_EQ(material.linear_density, 30e-6);
  EXPECT_DOUBLE_EQ(material.axial_stiffness, 10);
  EXPECT_DOUBLE_EQ(material.bending_rigidity, 2e-9);
  EXPECT_DOUBLE_EQ(material.diameter, 1.048e-3);
  EXPECT_EQ(material.law, ContactLaw::core_shell);
  EXPECT_DOUBLE_EQ(material.contact_stiffness, 12);
  EXPECT_DOUBLE_EQ(material.core_diameter, 0.4e-3);
  EXPECT_DOUBLE_EQ(material.shell_exponent, 3);
}

}  // namespace
}  // namespace wale
