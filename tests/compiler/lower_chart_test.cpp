#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "compiler/passes.hpp"
#include "compiler/passes/program_codes.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/make_chart.hpp"

namespace wale {
namespace {

Program lower(const Chart& chart) {
  Diagnostics say;
  auto program = passes::lower_chart(chart, say);
  EXPECT_TRUE(say.all().empty());
  return program.value_or(Program{});
}

std::vector<Instruction> only(Op op, const Program& program) {
  std::vector<Instruction> found;
  std::copy_if(program.code.begin(), program.code.end(), std::back_inserter(found),
               [op](const Instruction& at) { return at.op == op; });
  return found;
}

std::string_view refusal(const Chart& chart) {
  Diagnostics say;
  EXPECT_FALSE(passes::lower_chart(chart, say));
  return say.all().size() == 1 ? say.all().front().code : "";
}

TEST(LowerChart, KnitsOnTheFrontBedAndPurlsOnTheBackBed) {
  for (const Instruction& at : only(Op::knit, lower(make_chart({"kpk"}))))
    EXPECT_EQ(at.needle, (Needle{at.cell.wale == 1 ? Bed::back : Bed::front, at.cell.wale}));
}

TEST(LowerChart, KnitsEveryCellOnceFromTheSideThatTheChartNames) {
  const auto stitches = only(Op::knit, lower(make_chart({"kkk", "kkk"})));
  ASSERT_EQ(stitches.size(), 6u);
  for (int i = 0; i < 6; ++i) {
    const Instruction& at = stitches[static_cast<std::size_t>(i)];
    EXPECT_EQ(at.cell, (ChartCell{i / 3, i < 3 ? 2 - i : i - 3}));
    EXPECT_EQ(at.direction, i < 3 ? Direction::decreasing : Direction::increasing);
  }
}

TEST(LowerChart, KnitsEveryCourseOfAPeriodicChartFromTheLeftWithAPieceOfItsOwn) {
  Chart chart = make_chart({"kpk", "kkk", "ppk"});
  chart.periodic = true;
  const Program program = lower(chart);
  const auto stitches = only(Op::knit, program);
  ASSERT_EQ(stitches.size(), 9u);
  for (int i = 0; i < 9; ++i) {
    EXPECT_EQ(stitches[static_cast<std::size_t>(i)].cell, (ChartCell{i / 3, i % 3}));
    EXPECT_EQ(stitches[static_cast<std::size_t>(i)].direction, Direction::increasing);
  }
  EXPECT_EQ(only(Op::in, program).size(), 3u);
  EXPECT_EQ(only(Op::out, program).size(), 3u);
}

void expect_transfers(const Chart& chart, std::size_t count) {
  const auto transfers = only(Op::split, lower(chart));
  EXPECT_EQ(transfers.size(), count);
  for (const Instruction& at : transfers) {
    EXPECT_TRUE(at.carriers.empty());
    EXPECT_EQ(at.needle.index, at.other.index);
    EXPECT_NE(at.needle.bed, at.other.bed);
  }
}

TEST(LowerChart, TransfersOnlyTheLoopsWhoseNextStitchIsOnTheOtherBed) {
  for (unsigned seed = 0; seed < 15; ++seed) {
    const Chart chart = make_random_chart(8, 6, Form::flat, seed);
    std::size_t changes = 0;
    for (std::size_t course = 1; course < chart.courses.size(); ++course)
      for (std::size_t wale = 0; wale < 8; ++wale)
        changes += chart.courses[course][wale].stitch != chart.courses[course - 1][wale].stitch;
    expect_transfers(chart, changes);
  }
}

/// Each purl of a tube is fetched from its half's bed, but for the first course, and brought back.
TEST(LowerChart, LetsTheLoopsOfATubeWaitOnTheirHalfsBed) {
  for (unsigned seed = 0; seed < 15; ++seed) {
    const Chart chart = make_random_chart(8, 6, Form::tube, seed);
    std::size_t purls = 0, first_purls = 0;
    for (const auto& course : chart.courses)
      for (const Cell& cell : course) purls += cell.stitch == Stitch::purl;
    for (const Cell& cell : chart.courses.front()) first_purls += cell.stitch == Stitch::purl;
    expect_transfers(chart, 2 * purls - first_purls);
    std::set<Needle> holding;
    for (const Instruction& at : lower(chart).code) {
      if (at.op == Op::split) holding.erase(at.needle), holding.insert(at.other);
      if (at.op != Op::knit) continue;
      holding.insert(at.needle);
      const bool in_front = at.cell.wale < 4;
      for (const Needle& needle : holding) {
        const bool of_this_half = (needle.index % 2 == 0) == in_front;
        EXPECT_TRUE(of_this_half || needle.bed == (in_front ? Bed::back : Bed::front)) << print(needle);
      }
    }
  }
}

TEST(LowerChart, NeedsNoTransferForRib) { EXPECT_TRUE(only(Op::split, lower(make_chart({"kpkp", "kpkp"}))).empty()); }

TEST(LowerChart, KeepsTheNeedleAcrossFromEveryLoopOfATubeFree) {
  std::set<Needle> used;
  for (const Instruction& at : only(Op::knit, lower(make_chart({"kkkkkkkk"}, Form::tube)))) used.insert(at.needle);
  EXPECT_EQ(used.size(), 8u);
  for (const Needle& needle : used)
    EXPECT_FALSE(used.contains({needle.bed == Bed::front ? Bed::back : Bed::front, needle.index}));
}

TEST(LowerChart, LeadsATubeRoundBothBedsWithoutCrossingThem) {
  for (const Side from : {Side::left, Side::right}) {
    Chart chart = make_chart({"kkkkkkkk", "kkkkkkkk"}, Form::tube);
    chart.first_course_from = from;
    const auto stitches = only(Op::knit, lower(chart));
    for (std::size_t i = 0; i < stitches.size(); ++i) {
      const bool front = stitches[i].needle.bed == Bed::front;
      EXPECT_EQ(stitches[i].direction == Direction::increasing, front == (from == Side::left));
      const Needle &here = stitches[i].needle, &next = stitches[(i + 1) % stitches.size()].needle;
      EXPECT_EQ(std::abs(next.index - here.index), next.bed == here.bed ? 2 : 1);
    }
  }
}

TEST(LowerChart, ShowsThePurlsOfATubeOnTheOtherBed) {
  for (const Instruction& at : only(Op::knit, lower(make_chart({"pppp"}, Form::tube))))
    EXPECT_EQ(at.needle.bed, at.cell.wale < 2 ? Bed::back : Bed::front);
}

TEST(LowerChart, BringsAYarnInBeforeItsFirstStitchAndTakesItOutAfterItsLast) {
  Chart chart = make_chart({"kk", "kk", "kk"});
  chart.yarns.push_back({"b", Material{}, "#000000"});
  chart.yarns.push_back({"spare", Material{}, "#000000"});
  for (Cell& cell : chart.courses[1]) cell.yarn = 1;
  const Program program = lower(chart);
  EXPECT_EQ(program.carriers, (std::vector<std::string>{"a", "b", "spare"}));
  std::string order;
  for (const Instruction& at : program.code)
    order += std::string(at.op == Op::in    ? "in "
                         : at.op == Op::out ? "out "
                                            : "") +
             program.carriers[static_cast<std::size_t>(at.carriers[0])] + ";";
  EXPECT_EQ(order, "in a;a;a;in b;b;b;out b;a;a;out a;");
}

TEST(LowerChart, GivesEveryInstructionItsCellItsTextAndItsLength) {
  const Chart chart = make_random_chart(6, 4, Form::flat, 5);
  for (const Instruction& at : lower(chart).code) {
    const Cell& cell =
        chart.courses.at(static_cast<std::size_t>(at.cell.course)).at(static_cast<std::size_t>(at.cell.wale));
    EXPECT_EQ(at.span.begin, cell.span.begin);
    EXPECT_EQ(at.stitch_length, at.op == Op::knit ? cell.stitch_length : 0);
  }
}

TEST(LowerChart, RefusesWhatCannotBeLaidOverTwoBeds) {
  EXPECT_EQ(refusal(Chart{}), codes::empty_chart);
  EXPECT_EQ(refusal(make_chart({"kkkkk"}, Form::tube)), codes::tube_wales);
  EXPECT_EQ(refusal(make_chart({"kk"}, Form::tube)), codes::tube_wales);
}

TEST(LowerChart, WritesThePrintedProgramsOnRecord) {
  expect_golden("ir/flat.k", print(lower(make_chart({"ppk", "kpk", "kkk"}))));
  expect_golden("ir/tube.k", print(lower(make_chart({"kpkk", "kkkk"}, Form::tube))));
}

}  // namespace
}  // namespace wale
