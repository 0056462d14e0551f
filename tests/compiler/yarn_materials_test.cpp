#include "compiler/yarn_materials.hpp"

#include <gtest/gtest.h>

namespace wale {
namespace {

using Names = std::vector<std::string>;

Names names_of(const std::vector<Material>& materials) {
  Names names;
  for (const Material& material : materials) names.push_back(material.name);
  return names;
}

TEST(YarnMaterials, AreThoseGivenByNameThenThatForAllThenThoseAssumed) {
  const std::vector<Material> assumed{{.name = "wool"}, {.name = "silk"}};
  YarnMaterials given;
  given.by_name.push_back({"b", {.name = "flax"}, {}});
  Diagnostics say;
  EXPECT_EQ(names_of(materials_of({"a", "b"}, given, assumed, "yarn", say)), (Names{"wool", "flax"}));
  given.otherwise = Material{.name = "hemp"};
  EXPECT_EQ(names_of(materials_of({"a", "b"}, given, assumed, "yarn", say)), (Names{"hemp", "flax"}));
  EXPECT_TRUE(say.all().empty());
}

TEST(YarnMaterials, AreAsTheHeadersNameThemWhereNothingIsSaid) {
  Program program;
  program.carriers = {"1", "2", "3", "4"};
  program.headers = {{"Yarn-2", "50-50 Rust"},
                     {"Yarn-3", "2-28 green, paper-as-printed;"},
                     {"Yarn-9", "silk"},
                     {"Width", "paper-as-printed"}};
  EXPECT_EQ(names_of(default_materials(program)),
            (Names{"acrylic_16_2", "acrylic_16_2", "paper-as-printed", "acrylic_16_2"}));
}

TEST(YarnMaterials, AreRefusedForAYarnThatIsNotThere) {
  YarnMaterials given;
  given.by_name.push_back({"7", {}, {nullptr, 3, 4}});
  Diagnostics say;
  materials_of({"1", "2"}, given, {{}, {}}, "carrier", say);
  ASSERT_EQ(say.all().size(), 1u);
  EXPECT_EQ(say.all()[0].message, "the pattern has no carrier \"7\"");
  EXPECT_EQ(say.all()[0].hint, "known are 1, 2");
  EXPECT_EQ(say.all()[0].span.begin, 3u);
}

}  // namespace
}  // namespace wale
