#include <gtest/gtest.h>

#include <chrono>

#include "compiler/passes.hpp"
#include "compiler/passes/program_codes.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/make_chart.hpp"
#include "tests/support/make_program.hpp"

namespace wale {
namespace {

using Loops = std::vector<int>;

#ifdef NDEBUG
constexpr double patience = 1;
#else
constexpr double patience = 15;  // sanitizers look at every access
#endif

StitchGraph knit(const std::string& text) {
  Diagnostics say;
  auto graph = passes::knit(make_program(text), say);
  EXPECT_TRUE(graph && say.all().empty()) << (say.all().empty() ? "" : say.all().front().message);
  return graph.value_or(StitchGraph{});
}

Loops through(const StitchGraph& graph, int loop) { return graph.loops.at(static_cast<std::size_t>(loop)).through; }

std::vector<bool> held(const StitchGraph& graph) {
  std::vector<bool> answer;
  for (const Loop& loop : graph.loops) answer.push_back(loop.held);
  return answer;
}

TEST(Knit, PullsEachLoopThroughTheOneBelow) {
  const StitchGraph graph = knit("in a\nknit + f0 a\nknit + f1 a\nknit - f1 a\nknit - f0 a\nout a\n");
  EXPECT_EQ(through(graph, 2), Loops{1});
  EXPECT_EQ(through(graph, 3), Loops{0});
  EXPECT_EQ(held(graph), (std::vector<bool>{false, false, true, true}));
}

TEST(Knit, MakesALoopWithoutAParentOnAnEmptyNeedle) { EXPECT_TRUE(through(knit("in a\nknit + b7 a\n"), 0).empty()); }

TEST(Knit, CarriesALoopToTheNeedleThatFacesIt) {
  const StitchGraph graph = knit("in a\nknit + f3 a\nrack 2\nxfer f3 b1\nrack 0\nknit - b1 a\nknit - f3 a\n");
  EXPECT_EQ(through(graph, 1), Loops{0});
  EXPECT_TRUE(through(graph, 2).empty());
}

TEST(Knit, LaysATuckBehindTheLoopsOfAFrontNeedleAndBeforeThoseOfABackNeedle) {
  EXPECT_EQ(through(knit("in a\nknit + f0 a\ntuck - f0 a\nknit + f0 a\n"), 2), (Loops{0, 1}));
  EXPECT_EQ(through(knit("in a\nknit + b0 a\ntuck - b0 a\nknit + b0 a\n"), 2), (Loops{1, 0}));
}

TEST(Knit, LaysArrivingLoopsNearestTheGapInTheirOrder) {
  // b0 holds loops 1, 0 from front to back; they arrive behind loop 2 on f0, in that order.
  const std::string text = "in a\nknit + b0 a\ntuck - b0 a\ntuck + f0 a\n";
  EXPECT_EQ(through(knit(text + "xfer b0 f0\nknit - f0 a\n"), 3), (Loops{2, 1, 0}));
  EXPECT_EQ(through(knit(text + "xfer f0 b0\nknit - b0 a\n"), 3), (Loops{2, 1, 0}));
}

TEST(Knit, KeepsTheOrderOfAStackThatGoesAcrossAndBack) {
  const std::string text = "in a\ntuck + f0 a\ntuck - f0 a\ntuck + f0 a\n";
  EXPECT_EQ(through(knit(text + "xfer f0 b0\nknit - b0 a\n"), 3), (Loops{0, 1, 2}));
  EXPECT_EQ(through(knit(text + "xfer f0 b0\nxfer b0 f0\nknit - f0 a\n"), 3), (Loops{0, 1, 2}));
}

TEST(Knit, SplitsALoopSoThatItStaysAliveOnTheOtherBed) {
  const StitchGraph graph = knit("in a\nknit + f0 a\nsplit + f0 b0 a\nknit - b0 a\n");
  EXPECT_EQ(through(graph, 1), Loops{0});
  EXPECT_EQ(through(graph, 2), Loops{0});
  EXPECT_EQ(held(graph), (std::vector<bool>{false, true, true}));
}

TEST(Knit, MakesOneLoopACarrierWhenSeveralKnitAsOne) {
  const StitchGraph front = knit("in a b\nknit + f0 a b\nknit - f0 a b\n");
  ASSERT_EQ(front.loops.size(), 4u);
  EXPECT_EQ(through(front, 2), (Loops{0, 1}));
  EXPECT_EQ(through(front, 3), (Loops{0, 1}));
  EXPECT_EQ(front.yarns[1].loops, (Loops{1, 3}));
  EXPECT_EQ(through(knit("in a b\nknit + b0 a b\nknit - b0 a b\n"), 2), (Loops{0, 1}));
}

TEST(Knit, LaysTheFirstOfSeveralCarriersBehindIfAsked) {
  for (const std::string bed : {"f", "b"}) {
    Program program = make_program("in a b\nknit + " + bed + "0 a b\nknit - " + bed + "0 a b\n");
    program.plating = Plating::first_behind;
    Diagnostics say;
    const auto graph = passes::knit(program, say);
    ASSERT_TRUE(graph);
    const Loops parents = through(*graph, 2);
    ASSERT_EQ(parents.size(), 2u);
    EXPECT_EQ(graph->loops.at(static_cast<std::size_t>(parents[0])).carrier, 1) << "b in front";
    EXPECT_EQ(graph->loops.at(static_cast<std::size_t>(parents[1])).carrier, 0);
    EXPECT_EQ(graph->on_needles.at(0).loops, (Loops{2, 3}));
    EXPECT_EQ(graph->loops[3].carrier, 0);
  }
}

TEST(Knit, DropsALoopThatIsKnitWithoutYarn) {
  const StitchGraph graph = knit("in a\nknit + f0 a\namiss f0\ndrop f0\nknit - f0 a\n");
  EXPECT_TRUE(through(graph, 1).empty());
  EXPECT_EQ(held(graph), (std::vector<bool>{false, true}));
}

TEST(Knit, CountsThePassesOfEachYarn) {
  const StitchGraph graph = knit(
      "in a\nin b\nknit + f0 a\nknit + b0 a\nknit + f1 a\nknit + f0 b\nknit - f1 a\nmiss + f5 a\nknit - f0 a\n"
      "knit + f0 b\n");
  Loops passes;
  for (const Loop& loop : graph.loops) passes.push_back(loop.course);
  EXPECT_EQ(passes, (Loops{0, 0, 0, 0, 1, 3, 1}));
}

TEST(Knit, BeginsANewYarnWhereACarrierComesInAgain) {
  const StitchGraph graph = knit("in a\nknit + f0 a\nout a\nin a\nknit + f0 a\nout a\n");
  ASSERT_EQ(graph.yarns.size(), 2u);
  EXPECT_EQ(graph.yarns[1].carrier, 0);
  EXPECT_EQ(graph.yarns[1].loops, Loops{1});
  EXPECT_EQ(graph.loops[1].course, 0);
}

TEST(Knit, RemembersTheNeedlesThatALoopWasOn) {
  const StitchGraph graph = knit("in a\nknit + f3 a\nrack 2\nxfer f3 b1\nrack 1\nxfer b1 fs2\nxfer fs2 b1\n");
  const Loop& loop = graph.loops[0];
  ASSERT_EQ(loop.moves.size(), 3u);
  EXPECT_EQ(loop.moves[0].to, (Needle{Bed::back, 1}));
  EXPECT_EQ(loop.moves[0].racking, 2);
  EXPECT_EQ(loop.moves[0].instruction, 3);
  EXPECT_EQ(loop.moves[1].to, (Needle{Bed::front_slider, 2}));
  EXPECT_EQ(loop.last_needle, (Needle{Bed::back, 1}));
  EXPECT_EQ(loop.last_racking, 1);
  EXPECT_EQ(loop.instruction, 1);
  EXPECT_EQ(loop.released, -1);
  ASSERT_EQ(graph.on_needles.size(), 1u);
  EXPECT_EQ(graph.on_needles[0].needle, (Needle{Bed::back, 1}));
}

TEST(Knit, TellsADroppedLoopFromOneThatHoldsAnother) {
  const StitchGraph graph = knit("in a\nknit + f0 a\nsplit + f0 b0 a\ndrop b0\ndrop f0\n");
  EXPECT_FALSE(graph.loops[0].dropped) << "loop 1 is pulled through it";
  EXPECT_EQ(graph.loops[0].released, 3);
  EXPECT_TRUE(graph.loops[1].dropped);
  EXPECT_EQ(graph.loops[1].released, 4);
}

TEST(Knit, TakesWaitingCarriersAlongWithATransfer) {
  const StitchGraph graph = knit(
      "in a\nin b\nknit + f1 a\nknit + f2 a\nmiss + f3 b\nxfer f2 b2\nrack -1\nxfer b2 f1\nxfer f3 b4\nknit - f0 a\n"
      "miss - f3 b\n");
  EXPECT_EQ(graph.loops[2].from.needle, (Needle{Bed::front, 1}));
  EXPECT_EQ(graph.loops[2].from.side, Direction::increasing);
  EXPECT_EQ(graph.loops[0].from.side, Direction::none);
  const StitchGraph empty = knit("in a\nknit + f1 a\nmiss + f3 a\nxfer f3 b3\nknit - f1 a\n");
  EXPECT_EQ(empty.loops[1].from.needle, (Needle{Bed::back, 3})) << "a needle without loops takes carriers along too";
}

TEST(Knit, DoesNotDragTheCarrierThatSplits) {
  const StitchGraph graph = knit("in a\nknit + f1 a\nsplit + f1 b1 a\nknit - f1 a\n");
  EXPECT_EQ(graph.loops[2].from.needle, (Needle{Bed::front, 1}));
}

TEST(Knit, ListsTheNeedlesThatAYarnPasses) {
  const StitchGraph graph = knit("in a\nmiss - f9 a\nknit - f5 a\nrack 0.25\nmiss - b3 a\nknit - f1 a\nout a\n");
  const YarnPath& yarn = graph.yarns.at(0);
  ASSERT_EQ(yarn.misses.size(), 2u);
  EXPECT_EQ(yarn.misses[0].loops_before, 0);
  EXPECT_EQ(yarn.misses[1].loops_before, 1);
  EXPECT_EQ(yarn.misses[1].needle, (Needle{Bed::back, 3}));
  EXPECT_EQ(yarn.misses[1].racking, 0.25);
  EXPECT_EQ(yarn.came_in, 0);
  EXPECT_EQ(yarn.went_out, 6);
  EXPECT_EQ(yarn.end.needle, (Needle{Bed::front, 1}));
}

TEST(Knit, CountsTheNeedlesInUse) {
  EXPECT_EQ(knit("in a\nknit + f0 a\nknit + f1 a\nxfer f0 b0\nxfer f1 b1\nknit - b0 a\n").widest, 2);
}

TEST(Knit, RefusesToPileUpLoopsWithoutEnd) {
  std::string text = "in a\n";
  for (int i = 0; i < 101; ++i) text += "tuck + f0 a\n";
  Diagnostics say;
  EXPECT_FALSE(passes::knit(make_program(text), say));
  EXPECT_EQ(say.all().at(0).code, codes::stack_absurd);
}

TEST(Knit, GoesOnPastFaultsWhenAsked) {
  const StitchGraph graph = passes::knit_all(
      make_program("knit + f1 a\nin a\nknit + f2 a a\nxfer f2 f2\nxfer f2 f1\nknit - f2000000000 a\nknit + fs1 a\n"));
  EXPECT_EQ(graph.loops.size(), 3u);
  EXPECT_EQ(graph.yarns.size(), 1u);
  ASSERT_EQ(graph.on_needles.size(), 2u);
  EXPECT_EQ(graph.on_needles[0].loops, (Loops{0, 1}));
}

TEST(Knit, CountsCoursesFromTheCastOn) {
  // A cast-on to and fro, a course of knits, then a tuck that the next course takes up.
  const StitchGraph graph = knit(
      "in a\ntuck - f2 a\ntuck - f0 a\ntuck + f1 a\nknit - f2 a\nknit - f1 a\nknit - f0 a\nknit + f0 a\ntuck + f1 a\n"
      "knit + f2 a\nknit - f2 a\nknit - f1 a\nknit - f0 a\n");
  EXPECT_EQ(courses_of(graph), (Loops{0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3}));
}

TEST(Knit, TakesNegativeNeedles) { EXPECT_EQ(through(knit("in a\nknit + f-3 a\nknit - f-3 a\n"), 1), Loops{0}); }

TEST(Knit, LeavesTheOrderOfALoweredChartAsMade) {
  Diagnostics say;
  const Chart chart = make_random_chart(8, 6, Form::tube, 11);
  const StitchGraph graph = *passes::knit(*passes::lower_chart(chart, say), say);
  ASSERT_EQ(graph.yarns.size(), 1u);
  ASSERT_EQ(graph.loops.size(), 48u);
  for (int i = 0; i < 48; ++i) {
    EXPECT_EQ(through(graph, i), i < 8 ? Loops{} : Loops{i - 8});
    EXPECT_EQ(graph.yarns[0].loops[static_cast<std::size_t>(i)], i);
    EXPECT_EQ(graph.loops[static_cast<std::size_t>(i)].held, i >= 40);
  }
}

struct Illegal {
  std::string text, bad_line;
  std::string_view code;
};

TEST(Knit, RefusesWhatAMachineCannotDoAtItsLine) {
  const std::vector<Illegal> all{
      {"knit + f0 a\n", "knit + f0 a", codes::carrier_not_in},
      {"in a\nout a\nmiss + f0 a\n", "miss + f0 a", codes::carrier_not_in},
      {"out a\n", "out a", codes::carrier_not_in},
      {"in a\ninhook a\n", "inhook a", codes::carrier_already_in},
      {"in\n", "in", codes::carrier_missing},
      {"in a\nknit + f0 a a\n", "knit + f0 a a", codes::carrier_twice},
      {"in a\nknit + f3 a\nrack 1\nxfer f3 b3\n", "xfer f3 b3", codes::not_facing},
      {"in a\nknit + f3 a\nrack 0.25\nxfer f3 b3\n", "xfer f3 b3", codes::not_facing},
      {"in a\nsplit + f3 f3 a\n", "split + f3 f3 a", codes::same_bed},
      {"in a\nknit + f0 a\nxfer f0 bs0\nxfer bs0 fs0\n", "xfer bs0 fs0", codes::slider},
      {"in a\nknit + fs0 a\n", "knit + fs0 a", codes::slider},
      {"in a\nknit + f2000000000 a\n", "knit + f2000000000 a", codes::needle_out_of_range},
      {"in a\nknit + f-2147483648 a\nknit + f2147483647 a\n", "knit + f-2147483648 a", codes::needle_out_of_range}};
  for (const Illegal& one : all) {
    SCOPED_TRACE(one.text);
    Diagnostics say;
    EXPECT_FALSE(passes::knit(make_program(one.text), say));
    ASSERT_EQ(say.all().size(), 1u);
    EXPECT_EQ(say.all()[0].code, one.code);
    EXPECT_EQ(one.text.substr(say.all()[0].span.begin, say.all()[0].span.end - say.all()[0].span.begin), one.bad_line);
  }
}

TEST(Knit, RefusesAStitchWithoutADirection) {
  Program program = make_program("in a\nknit + f0 a\n");
  program.code[1].direction = Direction::none;
  Diagnostics say;
  EXPECT_FALSE(passes::knit(program, say));
  EXPECT_EQ(say.all().at(0).code, codes::direction_missing);
}

TEST(Knit, RunsAMillionInstructionsInTwoSecondsWhenOptimised) {
  Diagnostics say;
  const Program program = *passes::lower_chart(make_random_chart(700, 1000, Form::flat, 1), say);
  ASSERT_GT(program.code.size(), 1000000u);
  const auto start = std::chrono::steady_clock::now();
  const auto graph = passes::knit(program, say);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  EXPECT_EQ(graph->loops.size(), 700000u);
  RecordProperty("seconds", std::to_string(seconds));
  EXPECT_LT(seconds, 2 * patience);
}

TEST(Knit, PrintsTheGraphsOnRecord) {
  Diagnostics say;
  expect_golden("ir/flat.graph",
                print(*passes::knit(*passes::lower_chart(make_chart({"ppk", "kpk", "kkk"}), say), say)));
  expect_golden("ir/tube.graph",
                print(*passes::knit(*passes::lower_chart(make_chart({"kpkk", "kkkk"}, Form::tube), say), say)));
  expect_golden("ir/stacks.graph",
                print(knit("in a\nknit + f0 a\nknit + f1 a\nxfer f1 b1\nrack -1\nxfer b1 f0\nrack 0\n"
                           "tuck - f1 a\nknit - f0 a\n")));
}

}  // namespace
}  // namespace wale
