#include <gtest/gtest.h>

#include "compiler/compile.hpp"
#include "compiler/passes/program_codes.hpp"
#include "tests/support/make_program.hpp"

namespace wale {
namespace {

/// Codes and lines of what is told of a program, in brief: "G004 5".
std::vector<std::string> told(const std::string& body) {
  const Source source{"test.k", ";!knitout-2\n;;Carriers: 1 2\n" + body};
  Diagnostics say;
  const Program program = passes::parse_knitout(source, say);
  const auto graph = passes::knit(program, say);
  if (graph) passes::check_knitting(program, *graph, say);
  std::vector<std::string> brief;
  for (const Diagnostic& one : say.all())
    brief.push_back(std::string(one.code) + " " + std::to_string(locate(one.span).line));
  return brief;
}

using Told = std::vector<std::string>;

const std::string two_courses = "in 1\nknit + f0 1\nknit + f1 1\nknit - f1 1\nknit - f0 1\n";

TEST(CheckKnitting, WarnsOfLoopsLeftOnTheNeedles) {
  EXPECT_EQ(told(two_courses + "out 1\n"), Told{"G004 6"});
  EXPECT_EQ(told("in 1\nknit + f0 1\nout 1\ndrop f0\n"), Told{});
}

TEST(CheckKnitting, WarnsOfTheColumnThatADroppedLoopUnravels) {
  EXPECT_EQ(told(two_courses + "out 1\ndrop f0\ndrop f1\n"), Told{"G006 9"});
}

TEST(CheckKnitting, LeavesAColumnAloneThatAnotherLoopHolds) {
  // Loop 0 goes to the back bed and holds loop 1, which is knitted on; dropping loop 0 then frees nothing.
  EXPECT_EQ(told("in 1\nknit + f0 1\nsplit + f0 b0 1\ndrop b0\nout 1\n"), Told{"G004 5"});
}

TEST(CheckKnitting, WarnsOfMoreLoopsThanAHookTakes) {
  const std::string four = "in 1\ntuck + f0 1\ntuck - f0 1\ntuck + f0 1\ntuck - f0 1\n";
  EXPECT_EQ(told(four + "knit + f0 1\nout 1\ndrop f0\n"), Told{"G006 10"});
  EXPECT_EQ(told(four + "tuck + f0 1\nknit - f0 1\nout 1\n"), (Told{"G005 9", "G004 9"}));
}

TEST(CheckKnitting, WarnsOfACarrierThatLeavesAfterItsLoopWasDropped) {
  EXPECT_EQ(told("in 1\nknit + f0 1\ndrop f0\nout 1\n"), Told{"G007 6"});
}

TEST(CheckKnitting, NotesAnEmptyNeedleThatIsDroppedOrTransferred) {
  EXPECT_EQ(told("drop f0\nxfer f1 b1\nknit + f3\n"), Told{"G008 3"});
}

}  // namespace
}  // namespace wale
