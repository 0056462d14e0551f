#include <gtest/gtest.h>

#include "compiler/passes.hpp"
#include "compiler/passes/program_codes.hpp"
#include "tests/support/make_chart.hpp"
#include "tests/support/make_program.hpp"

namespace wale {
namespace {

Diagnostics check(const std::string& text) {
  Diagnostics say;
  passes::check_graph(*passes::knit(make_program(text), say), say);
  return say;
}

/// The one finding, and the line it points at.
std::string only_line(const std::string& text, std::string_view code) {
  const Diagnostics say = check(text);
  EXPECT_EQ(say.all().size(), 1u);
  if (say.all().empty()) return {};
  EXPECT_EQ(say.all()[0].code, code);
  EXPECT_EQ(say.all()[0].severity, Severity::warning);
  return text.substr(say.all()[0].span.begin, say.all()[0].span.end - say.all()[0].span.begin);
}

TEST(CheckGraph, PassesEveryGraphThatComesFromAChart) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    Diagnostics say;
    const Chart chart = make_random_chart(18, 7, seed % 2 ? Form::tube : Form::flat, seed);
    passes::check_graph(*passes::knit(*passes::lower_chart(chart, say), say), say);
    EXPECT_TRUE(say.all().empty());
  }
}

TEST(CheckGraph, PassesACastOnThatTakesEveryOtherNeedle) {
  EXPECT_TRUE(check("in a\nknit - f3 a\nknit - f1 a\nknit + f0 a\nknit + f2 a\nknit - f3 a\n").all().empty());
}

TEST(CheckGraph, WarnsOfALoopWithoutAParentAboveTheCastOn) {
  EXPECT_EQ(only_line("in a\nknit + f0 a\nknit - f0 a\nknit + f0 a\nknit + f1 a\n", codes::knit_on_empty),
            "knit + f1 a");
}

TEST(CheckGraph, TakesATuckForAMeantLoop) {
  EXPECT_TRUE(check("in a\nknit + f0 a\nknit - f0 a\nknit + f0 a\ntuck + f1 a\n").all().empty());
}

TEST(CheckGraph, WarnsOfALoopThatRuns) {
  EXPECT_EQ(only_line("in a\nknit + f0 a\nknit + f1 a\ndrop f0\n", codes::loop_runs), "knit + f0 a");
}

TEST(CheckGraph, ReportsAWholeCourseOfOneMistakeOnce) {
  const Diagnostics say = check("in a\nknit + f0 a\nknit + f1 a\nknit + f2 a\ndrop f0\ndrop f1\ndrop f2\n");
  ASSERT_EQ(say.all().size(), 1u);
  EXPECT_NE(say.all()[0].message.find("(and 2 more)"), std::string::npos);
}

TEST(CheckGraph, WarnsOfALongFloat) {
  EXPECT_TRUE(check("in a\nknit + f0 a\nknit + f20 a\n").all().empty());
  EXPECT_EQ(only_line("in a\nknit + f0 a\nknit + b21 a\n", codes::long_float), "knit + b21 a");
}

}  // namespace
}  // namespace wale
