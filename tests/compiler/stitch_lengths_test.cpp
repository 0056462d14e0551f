#include "compiler/stitch_lengths.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/passes.hpp"

namespace wale {
namespace {

std::optional<StitchLengths> parse(std::string_view text, std::size_t errors = 0) {
  Diagnostics say;
  auto lengths = parse_stitch_lengths(text, {}, say);
  EXPECT_EQ(say.all().size(), errors) << text;
  return lengths;
}

TEST(StitchLengths, AreReadAsOneOrBySetting) {
  EXPECT_DOUBLE_EQ(parse("9 mm")->at("5"), 9e-3);
  const StitchLengths both = *parse("9 mm, 6 = 1 cm,25/40=8mm");
  EXPECT_DOUBLE_EQ(both.at("6"), 1e-2);
  EXPECT_DOUBLE_EQ(both.at("25/40"), 8e-3);
  EXPECT_DOUBLE_EQ(both.at("A"), 9e-3);
  EXPECT_EQ(parse("6 = 10 mm")->at("5"), 0);
}

TEST(StitchLengths, RefuseWhatIsNoLength) {
  for (const char* text : {"", "9", "9 kg", "9 km", "-9 mm", "5 =", "9 mm,"}) EXPECT_FALSE(parse(text, 1)) << text;
}

TEST(StitchLengths, RefuseASettingThatNoProgramHas) {
  for (const char* text : {"= 9 mm", "five = 9 mm", "25- = 9 mm", "25/ = 9 mm", "9 mm, 25/4x = 9 mm"})
    EXPECT_FALSE(parse(text, 1)) << text;
}

TEST(StitchLengths, SayAtItsOwnPlaceWhatIsWrong) {
  const Source source{"--stitch-length", "9 mm, 6 = 9 kg"};
  Diagnostics say;
  EXPECT_FALSE(parse_stitch_lengths(source.text, {&source, 0, 14}, say));
  EXPECT_EQ(say.all().at(0).span.begin, 10u);
  EXPECT_EQ(say.all().at(0).span.end, 14u);
}

TEST(StitchLengths, AreThreePitchesWhereNothingIsSaid) {
  Program program;
  EXPECT_EQ(default_stitch_lengths(program).at("5"), 0) << "without a machine or a gauge nothing is known";
  program.machine = "kniterate";
  EXPECT_DOUBLE_EQ(default_stitch_lengths(program).at("5"), 3 * 0.0254 / 7);
  EXPECT_DOUBLE_EQ(default_stitch_lengths(program).at("A"), 3 * 0.0254 / 7 * 1.3);
  program.machine = "SWG091N2";
  program.gauge = 7.5;
  EXPECT_DOUBLE_EQ(default_stitch_lengths(program).at("101"), 3 * 0.0254 / 7.5);
}

TEST(StitchLengths, GivenOnesComeBeforeAssumedOnes) {
  Program program;
  program.machine = "Kniterate";
  const StitchLengths assumed = default_stitch_lengths(program);
  EXPECT_EQ(merged(*parse("6 = 10 mm"), assumed).at("7"), assumed.at("7"));
  EXPECT_DOUBLE_EQ(merged(*parse("6 = 10 mm"), assumed).at("6"), 1e-2);
  EXPECT_DOUBLE_EQ(merged(*parse("9 mm"), assumed).at("7"), 9e-3);
}

TEST(StitchLengths, FollowTheProgramsSettings) {
  const Source source{
      "test.k",
      ";!knitout-2\n;;Carriers: 1\nin 1\nknit + f0 1\nx-stitch-number  6\nx-stitch-numbers 7\ntuck + f1 1\n"
      "xfer f1 b1\nstitch 25 40.5\nsplit + f0 b0 1\n"};
  Diagnostics say;
  Program program = passes::parse_knitout(source, say);
  passes::set_stitch_lengths(program, *parse("9 mm, 6 = 10 mm, 25/40.5 = 8 mm"));
  std::vector<long> millimetres;
  for (const Instruction& at : program.code) millimetres.push_back(std::lround(at.stitch_length * 1e3));
  EXPECT_EQ(millimetres, (std::vector<long>{0, 9, 0, 0, 10, 0, 0, 8}));
}

}  // namespace
}  // namespace wale
