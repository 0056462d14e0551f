#include <gtest/gtest.h>

#include "compiler/passes.hpp"
#include "compiler/passes/program_codes.hpp"
#include "tests/support/make_chart.hpp"

namespace wale {
namespace {

struct Written {
  Source source;
  Program program;
  StitchGraph graph;
};

/// The chart as a machine's program, written, read back and knitted.
Written write(const Chart& chart, const char* machine) {
  Diagnostics say;
  Written made{{"chart.k", ""}, {}, {}};
  const auto program = passes::machine_program(chart, *find_target(machine), say);
  EXPECT_TRUE(program);
  made.source.text = print(*program);
  made.program = passes::parse_knitout(made.source, say);
  passes::check_program(made.program, say);
  if (auto graph = passes::knit(made.program, say)) made.graph = std::move(*graph);
  EXPECT_TRUE(say.all().empty()) << print(say.all().at(0));
  return made;
}

/// A loop as both graphs should have it: the cast-on is not among those that it goes through.
std::string describe(const StitchGraph& graph, int i, int first) {
  const Loop& loop = graph.loops[static_cast<std::size_t>(i)];
  std::string text = (loop.kind == LoopKind::knit ? "knit " : "tuck ") + print(loop.needle) +
                     (loop.direction == Direction::increasing ? "+" : "-") + " through";
  for (const int below : loop.through)
    if (below >= first) text += " " + std::to_string(below - first);
  return text;
}

/// With a cast-on a loop of the first course goes through one tuck; then come the chart's loops as the chart alone
/// knits them; then, with a bind-off, one loop a wale.
void expect_same_fabric(const Chart& chart, const char* machine) {
  Diagnostics say;
  const StitchGraph alone = *passes::knit(*passes::lower_chart(chart, say), say);
  const Written written = write(chart, machine);
  const int first = chart.start == Edge::cast_on ? chart.wales() : 0;
  const int after = chart.end == Edge::bind_off ? chart.wales() : 0;
  const int count = static_cast<int>(alone.loops.size());
  ASSERT_EQ(static_cast<int>(written.graph.loops.size()), first + count + after);
  for (int i = 0; i < count; ++i) {
    EXPECT_EQ(describe(written.graph, first + i, first), describe(alone, i, 0)) << "loop " << i;
    EXPECT_EQ(written.graph.loops[static_cast<std::size_t>(first + i)].carrier,
              alone.loops[static_cast<std::size_t>(i)].carrier);
  }
  for (int i = 0; i < first; ++i) EXPECT_EQ(written.graph.loops[static_cast<std::size_t>(i)].kind, LoopKind::tuck);
  int held = 0;
  for (const HeldLoops& needle : written.graph.on_needles) held += static_cast<int>(needle.loops.size());
  EXPECT_EQ(held, after > 0 ? 1 : chart.wales());
}

TEST(MachineProgram, KnitsTheSameFabricAsTheChart) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    Chart chart = make_random_chart(4 + 2 * static_cast<int>(seed % 5), 1 + static_cast<int>(seed % 7),
                                    seed % 2 ? Form::tube : Form::flat, seed);
    if (seed % 3 == 0) chart.first_course_from = Side::left;
    if (seed % 5 == 1) chart.start = Edge::open;
    if (seed % 5 == 2) chart.end = Edge::open;
    expect_same_fabric(chart, seed % 4 < 2 ? "kniterate" : "swg");
  }
}

TEST(MachineProgram, KnitsIntarsiaWithACarrierAYarn) {
  for (const char* machine : {"kniterate", "swg"}) {
    Chart chart = make_random_chart(9, 6, Form::flat, 3);
    chart.yarns.push_back({"b", Material{}, "#000000"});
    for (auto& course : chart.courses)
      for (std::size_t wale = 5; wale < course.size(); ++wale) course[wale].yarn = 1;
    expect_same_fabric(chart, machine);
  }
}

TEST(MachineProgram, TakesOneWale) { expect_same_fabric(make_chart({"k", "p", "k"}), "kniterate"); }

TEST(MachineProgram, BindsOffEveryWaleInAChain) {
  const Written written = write(make_chart({"kpk", "kkk"}), "kniterate");
  const auto loops = static_cast<int>(written.graph.loops.size());
  for (int i = loops - 2; i < loops; ++i) {
    const std::vector<int>& through = written.graph.loops[static_cast<std::size_t>(i)].through;
    ASSERT_EQ(through.size(), 2u);
    EXPECT_EQ(std::max(through[0], through[1]), i - 1) << "the chain's loop before";
  }
}

TEST(MachineProgram, WritesTheSizeNearestToTheStitchLengthWhereNumbersAreSizes) {
  Chart chart = make_chart({"k", "k"});
  chart.courses[0][0].stitch_length = 3 * 25.4e-3 / 7;
  chart.courses[1][0].stitch_length = 3 * 25.4e-3 / 7 * 1.13;
  EXPECT_EQ(write(chart, "kniterate").program.extensions,
            (std::vector<std::string>{"x-stitch-number 5", "x-stitch-number 7"}));
  EXPECT_TRUE(write(chart, "swg").program.extensions.empty());
}

TEST(MachineProgram, RefusesMoreYarnsThanCarriers) {
  Chart chart = make_chart({"kk"});
  for (int i = 0; i < 6; ++i) chart.yarns.push_back({"more", Material{}, "#000000"});
  Diagnostics say;
  EXPECT_FALSE(passes::machine_program(chart, *find_target("kniterate"), say));
  EXPECT_EQ(say.all().at(0).code, codes::too_many_yarns);
}

}  // namespace
}  // namespace wale
