#include "compiler/program.hpp"

#include <gtest/gtest.h>

#include "tests/support/make_program.hpp"

namespace wale {
namespace {

TEST(Program, IsPrintedInTheWordsOfKnitout) {
  const std::string text =
      ";!knitout-2\n"
      ";;Carriers: a b\n"
      "in a\n"
      "inhook b\n"
      "stitch 12 -3\n"
      "knit + f3 a\n"
      "knit - b-2 a b\n"
      "tuck + f0 b\n"
      "rack -1.75\n"
      "split - f3 b4 a\n"
      "miss + fs3 b\n"
      "releasehook b\n"
      "pause\n"
      "outhook b\n"
      "out a\n";
  EXPECT_EQ(print(make_program(text)), text);
}

TEST(Program, NamesAStitchWithoutYarnAsKnitoutDoes) {
  Program program;
  Instruction at;
  at.needle = {Bed::front, 3};
  at.other = {Bed::back, 3};
  at.op = Op::knit;
  EXPECT_EQ(print(at, program), "drop f3");
  at.op = Op::tuck;
  EXPECT_EQ(print(at, program), "amiss f3");
  at.op = Op::split;
  EXPECT_EQ(print(at, program), "xfer f3 b3");
}

TEST(Program, MarksWhereACourseOfTheChartBegins) {
  Program program = make_program("knit + f0 a\nxfer f0 b0\nknit - b0 a\n");
  program.code[0].cell = {0, 0};
  program.code[1].cell = program.code[2].cell = {1, 0};
  EXPECT_EQ(print(program),
            ";!knitout-2\n;;Carriers: a\n; course 1\nknit + f0 a\n; course 2\nxfer f0 b0\nknit - b0 a\n");
}

}  // namespace
}  // namespace wale
