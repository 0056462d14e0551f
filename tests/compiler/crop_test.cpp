#include <gtest/gtest.h>

#include "compiler/passes.hpp"
#include "tests/support/make_chart.hpp"
#include "tests/support/make_program.hpp"

namespace wale {
namespace {

using Loops = std::vector<int>;

StitchGraph jersey() {
  Diagnostics say;
  return *passes::knit(*passes::lower_chart(make_chart({"kkkk", "kkkk", "kkkk"}), say), say);
}

TEST(Crop, KeepsAllWhereNothingIsCutOff) { EXPECT_EQ(print(passes::crop(jersey(), {})), print(jersey())); }

TEST(Crop, KeepsCoursesAndHoldsTheCutEdge) {
  const StitchGraph cut = passes::crop(jersey(), {IntRange{2, 2}, {}});
  ASSERT_EQ(cut.loops.size(), 4u);
  ASSERT_EQ(cut.yarns.size(), 1u);
  EXPECT_EQ(cut.yarns[0].loops, (Loops{0, 1, 2, 3}));
  EXPECT_EQ(cut.on_needles.size(), 4u);
  for (const Loop& loop : cut.loops) {
    EXPECT_TRUE(loop.held);
    EXPECT_TRUE(loop.through.empty());
    EXPECT_EQ(loop.released, -1);
  }
}

TEST(Crop, CutsTheYarnWhereItLeavesTheNeedles) {
  const StitchGraph cut = passes::crop(jersey(), {{}, IntRange{1, 2}});
  ASSERT_EQ(cut.loops.size(), 6u);
  ASSERT_EQ(cut.yarns.size(), 3u);
  EXPECT_EQ(cut.yarns[1].loops, (Loops{2, 3}));
  EXPECT_EQ(cut.loops[2].through, Loops{1});
  EXPECT_EQ(cut.on_needles.size(), 2u);
}

TEST(Crop, KeepsTheMissesBetweenItsLoops) {
  Diagnostics say;
  const StitchGraph graph = *passes::knit(
      make_program("in a\nknit + f0 a\nmiss + f1 a\nknit + f2 a\nmiss + f3 a\nknit + f4 a\nmiss + f5 a\nout a\n"), say);
  const StitchGraph cut = passes::crop(graph, {{}, IntRange{2, 9}});
  ASSERT_EQ(cut.yarns.size(), 1u);
  ASSERT_EQ(cut.yarns[0].misses.size(), 2u);
  EXPECT_EQ(cut.yarns[0].misses[0].needle.index, 3);
  EXPECT_EQ(cut.yarns[0].misses[0].loops_before, 1);
  EXPECT_EQ(cut.yarns[0].misses[1].loops_before, 2);
  EXPECT_EQ(cut.yarns[0].came_in, -1);
  EXPECT_EQ(cut.yarns[0].went_out, 7);
}

TEST(Crop, MayLeaveNothing) {
  const StitchGraph cut = passes::crop(jersey(), {IntRange{7, 9}, {}});
  EXPECT_TRUE(cut.loops.empty() && cut.yarns.empty() && cut.on_needles.empty());
}

}  // namespace
}  // namespace wale
