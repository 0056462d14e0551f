#include <gtest/gtest.h>

#include "compiler/passes.hpp"
#include "compiler/passes/program_codes.hpp"
#include "tests/support/make_chart.hpp"
#include "tests/support/make_program.hpp"

namespace wale {
namespace {

Diagnostics check(const Program& program) {
  Diagnostics say;
  passes::check_program(program, say);
  return say;
}

std::vector<std::string_view> codes_of(const std::string& text) {
  std::vector<std::string_view> found;
  const Diagnostics say = check(make_program(text));
  for (const Diagnostic& one : say.all()) found.push_back(one.code);
  return found;
}

using Codes = std::vector<std::string_view>;

TEST(CheckProgram, PassesEveryProgramThatComesFromAChart) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    Diagnostics say;
    const Chart chart = make_random_chart(6, 5, seed % 2 ? Form::tube : Form::flat, seed);
    EXPECT_TRUE(check(*passes::lower_chart(chart, say)).all().empty());
  }
}

TEST(CheckProgram, RefusesACarrierThatIsOutOnce) {
  EXPECT_EQ(codes_of("knit + f0 a\nknit + f1 a\nout a\n"), Codes{codes::carrier_not_in});
  EXPECT_EQ(codes_of("in a\nknit + f0 a\nout a\nknit + f1 a\nout a\n"), Codes{codes::carrier_not_in});
}

TEST(CheckProgram, FindsEveryFaultWhereKnittingStopsAtTheFirst) {
  EXPECT_EQ(codes_of("in a\nknit + f0 a\nxfer f0 b1\nxfer f0 f1\nout a a\n"),
            (Codes{codes::not_facing, codes::same_bed, codes::carrier_twice}));
}

TEST(CheckProgram, WarnsOfACarrierThatIsLeftIn) {
  EXPECT_EQ(codes_of("in a\nknit + f0 a\n"), Codes{codes::carrier_left_in});
  EXPECT_FALSE(check(make_program("in a\nknit + f0 a\n")).failed());
}

TEST(CheckProgram, WarnsOfACarrierThatNeverKnits) {
  EXPECT_EQ(codes_of("in a\nmiss + f0 a\nout a\n"), Codes{codes::carrier_unused});
}

TEST(CheckProgram, WarnsOfABedRackedFartherThanMachinesGo) {
  EXPECT_EQ(codes_of("rack 4\nrack -4.5\nrack 0\n"), Codes{codes::racked_far});
}

TEST(CheckProgram, KnowsHowFarAMachineRacks) {
  Program program = make_program("rack 3\nrack 5\nrack 9\n");
  const std::map<std::string, std::size_t> warnings{{"Kniterate", 3}, {"SWG091N2", 1}, {"", 2}};
  for (const auto& [machine, count] : warnings) {
    program.machine = machine;
    EXPECT_EQ(check(program).all().size(), count) << machine;
  }
}

TEST(CheckProgram, RefusesABedRackedOutOfTheRoom) {
  EXPECT_EQ(codes_of("rack 1000000\n"), (Codes{codes::racking_absurd, codes::racked_far}));
}

TEST(CheckProgram, WarnsOfAHookThatIsAskedTooMuch) {
  const std::string one = "inhook a\nknit - f0 a\n";
  EXPECT_EQ(codes_of(one + "releasehook a\nouthook a\n"), Codes{});
  EXPECT_EQ(codes_of(one + "inhook b\nknit - f0 b\nreleasehook b\nout a b\n"), Codes{codes::hook_busy});
  EXPECT_EQ(codes_of(one + "outhook a\n"), Codes{codes::hook_busy});
  EXPECT_EQ(codes_of("releasehook a\n"), Codes{codes::hook_release});
  EXPECT_EQ(codes_of("inhook a\nreleasehook a\nknit - f0 a\nout a\n"), Codes{codes::hook_release});
  EXPECT_EQ(codes_of(one + "in b\nknit - f0 b\nreleasehook b\nout a b\n"), Codes{codes::hook_release});
}

TEST(CheckProgram, WarnsOfAMissThatMovesNothing) {
  Program program = make_program("miss + f0 a\nmiss + f0 a\n");
  for (Instruction& at : program.code) at.carriers.clear();
  const Diagnostics say = check(program);
  ASSERT_EQ(say.all().size(), 1u);
  EXPECT_EQ(say.all()[0].code, codes::miss_without_yarn);
}

}  // namespace
}  // namespace wale
