#include "compiler/passes/entanglements.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compiler/compile.hpp"
#include "compiler/passes/program_codes.hpp"
#include "sim/spline.hpp"
#include "tests/support/structures.hpp"

namespace wale {
namespace {

const std::string head = ";!knitout-2\n;;Carriers: 1 2\n;;Machine: Kniterate\n;;Gauge: 7\nin 1\nin 2\n";

std::string row(const std::string& op, char bed, int from, int to, const std::string& carrier) {
  std::string text;
  const int step = from <= to ? 1 : -1;
  for (int i = from; i != to + step; i += step)
    text += op + (step > 0 ? " + " : " - ") + bed + std::to_string(i) + " " + carrier + "\n";
  return text;
}

std::optional<Compiled> made(const std::string& text, Diagnostics& say) {
  const Source source{"made.k", text};
  const KnitoutOptions options{{}, {7.6e-3, {}}, Plating::first_in_front};
  return compile_knitout(source, options, {}, 12, say);
}

/// Jersey with a float over needles 3 and 4, behind their loops.
const std::string floated = head + row("knit", 'f', 0, 7, "1") + row("knit", 'f', 7, 0, "1") +
                            row("knit", 'f', 0, 2, "1") + row("knit", 'f', 5, 7, "1") + row("knit", 'f', 7, 0, "1");

/// Moves the yarn that lies within `reach` of a place, seen from the face, and that belongs to no loop.
Points float_moved(const Fabric& fabric, double x, double reach, const Vec3& by) {
  Points q = fabric.points;
  for (int i = 0; i < fabric.segment_count(); ++i) {
    const Vec3 middle = combine(q, fabric.first_point(i), basis(0.5).value);
    if (fabric.segment(i).stitch < 0 && std::abs(middle.x() - x) < reach) q.col(fabric.first_point(i) + 1) += by;
  }
  return q;
}

TEST(Entanglements, AreNotInAnyChart) {
  for (const auto& [name, chart] : all_structures()) {
    Diagnostics say;
    const auto compiled = compile_chart(chart, 12, say);
    ASSERT_TRUE(compiled) << name;
    EXPECT_TRUE(entanglements(compiled->graph, compiled->fabric).empty()) << name;
  }
}

TEST(Entanglements, AreFoundWhereAFloatGoesThroughALoop) {
  Diagnostics say;
  const auto compiled = made(floated, say);
  ASSERT_TRUE(compiled);
  EXPECT_TRUE(entanglements(compiled->graph, compiled->fabric).empty());
  const Arrangement& of = compiled->arrangement;
  const int passed = 12;  // on needle 3, knitted by the second row
  ASSERT_EQ(compiled->graph.loops[passed].needle.index, 3);
  const double x = of.anchors[static_cast<std::size_t>(of.loops[passed].feet)].at.x();
  const double d = compiled->fabric.materials.front().diameter;
  // Behind the left leg of the loop on needle 3, from there on in front.
  Fabric torn = compiled->fabric;
  torn.points = float_moved(torn, x + 3 * d, 3.7 * d, {0, 0, 8 * d});
  const auto found = entanglements(compiled->graph, torn);
  ASSERT_FALSE(found.empty());
  const auto floated_past = [&](const Entanglement& at) {
    const int needle = compiled->graph.loops[static_cast<std::size_t>(at.with)].needle.index;
    return needle == 3 || needle == 4;
  };
  EXPECT_TRUE(std::all_of(found.begin(), found.end(), floated_past));
}

TEST(Entanglements, AreToldByPlaceAndRefused) {
  Diagnostics say;
  auto compiled = made(floated, say);
  ASSERT_TRUE(compiled);
  const double d = compiled->fabric.materials.front().diameter;
  const double x = compiled->arrangement.anchors[static_cast<std::size_t>(compiled->arrangement.loops[12].feet)].at.x();
  compiled->fabric.points = float_moved(compiled->fabric, x + 3 * d, 3.7 * d, {0, 0, 8 * d});
  Diagnostics proof;
  passes::prove(compiled->graph, compiled->fabric, compiled->crossings, proof);
  ASSERT_TRUE(proof.failed());
  EXPECT_EQ(proof.all().back().code, codes::entangled);
  EXPECT_NE(proof.all().back().span.source, nullptr);
}

/// An inlay lies between the beds of a rib, held by tucks that are let go once the next row is knitted.
TEST(LetRun, LeavesAnInlayBetweenTheBeds) {
  std::string text = head;
  const auto rib = [](bool rightwards) {
    std::string made;
    for (int k = 0; k < 12; ++k) {
      const int i = rightwards ? k : 11 - k;
      made += std::string("knit ") + (rightwards ? "+ " : "- ") + (i % 2 ? "b" : "f") + std::to_string(i) + " 1\n";
    }
    return made;
  };
  text += rib(true) + rib(false) + rib(true);
  text += "tuck + b0 2\n" + row("miss", 'f', 1, 10, "2") + "tuck + f11 2\n" + rib(false) + "drop b0\ndrop f11\n" +
          rib(true);
  Diagnostics say;
  const Source source{"inlay.k", text};
  const Knitted knitted = knit_knitout(source, {}, say);
  const StitchGraph rest = passes::let_run(knitted.graph);
  EXPECT_LT(rest.loops.size(), knitted.graph.loops.size());
  for (const Loop& loop : rest.loops) EXPECT_FALSE(loop.dropped && loop.through.empty());
  std::size_t misses = 0, before = 0;
  for (const YarnPath& yarn : rest.yarns) misses += yarn.misses.size();
  for (const YarnPath& yarn : knitted.graph.yarns) before += yarn.misses.size();
  EXPECT_EQ(misses - before, knitted.graph.loops.size() - rest.loops.size());
}

/// Cast on, knitted and bound off by a machine, flat and in the round.
TEST(Entanglements, AreNotInWrittenCharts) {
  for (const Form form : {Form::flat, Form::tube})
    for (const auto& [name, chart] : basic_structures(8, 4, form)) {
      SCOPED_TRACE(name + (form == Form::tube ? ", tube" : ", flat"));
      Diagnostics say;
      const auto program = passes::machine_program(chart, *find_target("swg"), say);
      ASSERT_TRUE(program);
      const auto compiled = made(print(*program), say);
      EXPECT_TRUE(compiled) << (say.all().empty() ? "" : say.all().back().message);
      EXPECT_EQ(compiled && compiled->arrangement.strip.tube(), form == Form::tube);
    }
}

}  // namespace
}  // namespace wale
