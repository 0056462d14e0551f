#include "compiler/units.hpp"

#include <gtest/gtest.h>

namespace wale {
namespace {

double value(std::string_view text, const Dimension& dimension) {
  Diagnostics say;
  const auto number = parse_quantity(text, dimension, {}, say);
  EXPECT_TRUE(number) << text << (say.all().empty() ? "" : ": " + say.all()[0].message);
  return number.value_or(-1);
}

/// The code of the error that a quantity is refused with.
std::string refusal(std::string_view text, const Dimension& dimension) {
  Diagnostics say;
  EXPECT_FALSE(parse_quantity(text, dimension, {}, say)) << text;
  if (say.all().size() != 1) return "not one error";
  EXPECT_NE(say.all()[0].hint.find(dimension.example), std::string::npos);
  return std::string(say.all()[0].code);
}

TEST(Units, TurnIntoSi) {
  using namespace dimensions;
  EXPECT_DOUBLE_EQ(value("7.23 mm", length), 7.23e-3);
  EXPECT_DOUBLE_EQ(value("0.524mm", length), 0.524e-3);
  EXPECT_DOUBLE_EQ(value("1 inch", length), 0.0254);
  EXPECT_DOUBLE_EQ(value("524 µm", length), 524e-6);
  EXPECT_DOUBLE_EQ(value("79 MPa", stress), 79e6);
  EXPECT_DOUBLE_EQ(value("2.49e4 g/(cm s^2)", stress), 2490);
  EXPECT_DOUBLE_EQ(value("68.1 N", force), 68.1);
  EXPECT_DOUBLE_EQ(value("1.47e-8 N m^2", bending_rigidity), 1.47e-8);
  EXPECT_DOUBLE_EQ(value("14.7 mN mm2", bending_rigidity), 1.47e-8);
  EXPECT_DOUBLE_EQ(value("30 N/m", stiffness), 30);
  EXPECT_DOUBLE_EQ(value("30 J/m^2", stiffness), 30);
  EXPECT_DOUBLE_EQ(value("+20 ms", dimensions::time), 0.02);
  EXPECT_DOUBLE_EQ(value("0.02 kg/(m s)", drag), 0.02);
  EXPECT_DOUBLE_EQ(value("20 N s/m^3", contact_damping), 20);
}

TEST(Units, OfTheYarnTradeAreKnown) {
  using namespace dimensions;
  EXPECT_DOUBLE_EQ(value("77 tex", linear_density), 77e-6);
  EXPECT_DOUBLE_EQ(value("770 dtex", linear_density), 77e-6);
  EXPECT_NEAR(value("693 denier", linear_density), 77e-6, 1e-11);  // 9 denier are 1 tex; udunits rounds to 7 digits
}

TEST(Units, RatiosMayStandWithoutAUnit) {
  EXPECT_DOUBLE_EQ(value("60 %", dimensions::ratio), 0.6);
  EXPECT_DOUBLE_EQ(value("60%", dimensions::ratio), 0.6);
  EXPECT_DOUBLE_EQ(value("0.6", dimensions::ratio), 0.6);
}

TEST(Units, RefuseAQuantityWithoutAUnit) {
  EXPECT_EQ(refusal("7.23", dimensions::length), "U001");
  EXPECT_EQ(refusal(" 2 ", dimensions::time), "U001");
}

TEST(Units, RefuseALengthWhereAPressureIsWanted) {
  EXPECT_EQ(refusal("7.23 mm", dimensions::stress), "U002");
  EXPECT_EQ(refusal("77 tex", dimensions::length), "U002");
  EXPECT_EQ(refusal("5 %", dimensions::length), "U002");
  EXPECT_EQ(refusal("5 mm", dimensions::ratio), "U002");
}

TEST(Units, RefuseWhatIsNoNumber) {
  for (const char* text : {"", "long", "mm", "nan mm", "inf mm", "1e999 mm", "7,23 mm", "- 3 mm"}) {
    EXPECT_EQ(refusal(text, dimensions::length), "U003") << text;
  }
}

TEST(Units, RefuseUnknownUnitsAndHiddenFactors) {
  for (const char* text : {"7 milimeter", "7 23 mm", "7 mm 3", "7 mm)", "7 -mm", "7 mm + 3 mm"}) {
    EXPECT_EQ(refusal(text, dimensions::length), "U004") << text;
  }
}

TEST(Units, AreSilentOnStderr) {
  testing::internal::CaptureStderr();
  refusal("7 milimeter", dimensions::length);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace wale
