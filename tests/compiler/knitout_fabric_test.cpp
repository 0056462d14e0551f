#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "compiler/compile.hpp"
#include "compiler/demand.hpp"
#include "sim/clasps.hpp"
#include "sim/results/hdf5.hpp"
#include "sim/results/picture.hpp"
#include "sim/spline.hpp"
#include "tests/support/shared_files.hpp"
#include "tests/support/table.hpp"

namespace wale {
namespace {

namespace fs = std::filesystem;

const std::string head = ";!knitout-2\n;;Carriers: 1 2\n;;Machine: Kniterate\n;;Gauge: 7\n";
constexpr double d = 0.524e-3;

struct Made {
  Source source;
  Diagnostics say;
  std::optional<Compiled> fabric;
};

std::unique_ptr<Made> make(const std::string& name, const std::string& text, const YarnMaterials& yarns = {},
                           Plating plating = Plating::first_in_front) {
  auto made = std::make_unique<Made>();
  made->source = {name, text};
  const KnitoutOptions options{{}, {7.6e-3, {}}, plating};
  made->fabric = compile_knitout(made->source, options, yarns, 12, made->say);
  return made;
}

std::string lines(std::initializer_list<std::string> parts) {
  std::string text = head + "in 1\nin 2\n";
  for (const std::string& part : parts) text += part;
  return text;
}

/// `knit + f0 1` ... over needles `from` to `to`, in that order.
std::string row(const std::string& op, char bed, int from, int to, const std::string& carrier = "1") {
  std::string text;
  const int step = from <= to ? 1 : -1;
  for (int i = from; i != to + step; i += step)
    text += op + (step > 0 ? " + " : " - ") + bed + std::to_string(i) + " " + carrier + "\n";
  return text;
}

const Anchor& feet(const Made& made, int loop) {
  const Arrangement& of = made.fabric->arrangement;
  return of.anchors[static_cast<std::size_t>(of.loops[static_cast<std::size_t>(loop)].feet)];
}
const Anchor& head_of(const Made& made, int loop) {
  const Arrangement& of = made.fabric->arrangement;
  return of.anchors[static_cast<std::size_t>(of.loops[static_cast<std::size_t>(loop)].head)];
}

/// Points on the drawn yarn of one loop, or (-1) of floats and turns.
std::vector<Vec3> points_of(const Fabric& fabric, int loop) {
  std::vector<Vec3> points;
  for (int i = 0; i < fabric.segment_count(); ++i)
    if (fabric.segment(i).stitch == loop)
      for (int k = 0; k < 4; ++k) points.push_back(combine(fabric.points, fabric.first_point(i), basis(k / 4.0).value));
  return points;
}

/// The depth of some points nearest to a place seen from the face.
double depth_at(const std::vector<Vec3>& points, double x, double y) {
  const auto nearest = std::min_element(points.begin(), points.end(), [&](const Vec3& a, const Vec3& b) {
    return std::hypot(a.x() - x, a.y() - y) < std::hypot(b.x() - x, b.y() - y);
  });
  return nearest->z();
}

TEST(KnitoutFabric, OfJerseyIsARegularGrid) {
  const auto made = make("jersey.k", lines({row("knit", 'f', 3, 0), row("knit", 'f', 0, 3), row("knit", 'f', 3, 0)}));
  ASSERT_TRUE(made->fabric);
  const Vec3 wale = feet(*made, 1).at - feet(*made, 0).at, course = feet(*made, 7).at - feet(*made, 0).at;
  EXPECT_LT(wale.x(), -4 * d);
  EXPECT_NEAR(wale.y(), 0, 1e-3 * d);
  EXPECT_NEAR(course.x(), 0, 1e-3 * d);
  EXPECT_GT(course.y(), 3 * d);
  for (int i = 0; i < 4; ++i) {
    const int above = 7 - i;  // knitted on the way back
    EXPECT_LT((feet(*made, above).at - feet(*made, i).at - course).norm(), 1e-3 * d) << i;
    EXPECT_EQ(&feet(*made, above), &head_of(*made, i));
  }
}

std::string tube_rounds(int rounds) {
  std::string text;
  for (int round = 0; round < rounds; ++round) text += row("knit", 'b', 7, 0) + row("knit", 'f', 0, 7);
  return text;
}

TEST(KnitoutFabric, OfATubeIsRound) {
  const auto made = make("tube.k", lines({tube_rounds(4)}));
  ASSERT_TRUE(made->fabric);
  const Strip& strip = made->fabric->arrangement.strip;
  EXPECT_NEAR(strip.round, 16 * 5 * d, d);
  for (int i = 0; i < 64; ++i) {
    EXPECT_EQ(made->fabric->arrangement.loops[static_cast<std::size_t>(i)].sign, 1) << i;
    for (const Vec3& point : points_of(made->fabric->fabric, i))
      EXPECT_NEAR(std::hypot(point.x(), point.z()), strip.radius(), 1.2 * d) << i;
  }
}

/// A cast-on from bed to bed closes it; then it is drawn as it lies on the needles.
TEST(KnitoutFabric, OfABagHasTwoSheets) {
  std::string text = lines({});
  for (int i = 0; i < 8; ++i) text += "tuck + " + std::string(i % 2 ? "b" : "f") + std::to_string(i) + " 1\n";
  for (int i = 7; i >= 0; --i) text += "tuck - " + std::string(i % 2 ? "f" : "b") + std::to_string(i) + " 1\n";
  const auto made = make("bag.k", text + row("knit", 'f', 0, 7) + tube_rounds(3));
  ASSERT_TRUE(made->fabric);
  EXPECT_FALSE(made->fabric->arrangement.strip.tube());
  for (int i = 40; i < 64; ++i) {
    const bool back = i % 16 >= 8;
    EXPECT_GT((back ? -1 : 1) * feet(*made, i).at.z(), d) << i;
  }
}

TEST(KnitoutFabric, OfRibIsOneSheet) {
  std::string text = lines({});
  for (int pass = 0; pass < 4; ++pass)
    for (int k = 0; k < 8; ++k) {
      const int i = pass % 2 ? k : 7 - k;
      text += std::string("knit ") + (pass % 2 ? "+ " : "- ") + (i % 2 ? "f" : "b") + std::to_string(i) + " 1\n";
    }
  const auto made = make("rib.k", text);
  ASSERT_TRUE(made->fabric);
  for (int i = 0; i < 32; ++i) EXPECT_LT(std::abs(feet(*made, i).at.z()), 0.75 * d) << i;
}

TEST(KnitoutFabric, FloatsBehindLoopsOfTheFrontBedAndBeforeThoseOfTheBack) {
  for (const char bed : {'f', 'b'}) {
    const std::string miss = std::string("miss - ") + bed + "2 1\n";
    const auto made = make("float.k", lines({row("knit", bed, 0, 4), row("knit", bed, 4, 3), miss,
                                             row("knit", bed, 1, 0), row("knit", bed, 0, 4)}));
    ASSERT_TRUE(made->fabric);
    const int passed = 2;  // the loop on needle 2, made in the first row, knitted in the third
    ASSERT_EQ(made->fabric->graph.loops[passed].needle.index, 2);
    const Vec3 place = (feet(*made, passed).at + head_of(*made, passed).at) / 2;
    const double of_float = depth_at(points_of(made->fabric->fabric, -1), place.x(), feet(*made, 6).at.y() - d);
    const double of_loop = depth_at(points_of(made->fabric->fabric, passed), place.x() + d, place.y());
    EXPECT_GT((bed == 'f' ? 1 : -1) * (of_loop - of_float), 0.7 * d) << bed;
  }
}

TEST(KnitoutFabric, OfACableHasTheLoopInFrontThatWasOnTheFrontBed) {
  for (const bool left_first : {true, false}) {
    // Both loops go to the back; the first to come forward is on the front bed when the other passes it.
    const std::string rightwards = "rack 1\nxfer b1 f2\n", leftwards = "rack -1\nxfer b2 f1\n";
    const auto made = make("cable.k", lines({row("knit", 'f', 0, 3), row("knit", 'f', 3, 0), "xfer f1 b1\nxfer f2 b2\n",
                                             left_first ? rightwards + leftwards : leftwards + rightwards, "rack 0\n",
                                             row("knit", 'f', 0, 3), row("knit", 'f', 3, 0)}));
    ASSERT_TRUE(made->fabric);
    const int on_one = 6, on_two = 5;
    ASSERT_EQ(made->fabric->graph.loops[on_one].needle.index, 1);
    const Arrangement& of = made->fabric->arrangement;
    EXPECT_EQ(of.loops[on_one].passes, left_first ? 1 : -1);
    EXPECT_EQ(of.loops[on_two].passes, left_first ? -1 : 1);
    const Vec3 crossing = (feet(*made, on_one).at + head_of(*made, on_one).at) / 2;
    const double front =
        depth_at(points_of(made->fabric->fabric, left_first ? on_one : on_two), crossing.x(), crossing.y());
    const double behind =
        depth_at(points_of(made->fabric->fabric, left_first ? on_two : on_one), crossing.x(), crossing.y());
    EXPECT_GT(front - behind, d);
  }
}

TEST(KnitoutFabric, OfShortRowsIsHigherWhereMoreWereKnit) {
  const auto made = make(
      "dart.k", lines({row("knit", 'f', 0, 7), row("knit", 'f', 7, 0), row("knit", 'f', 0, 3), row("knit", 'f', 3, 0),
                       row("knit", 'f', 0, 3), row("knit", 'f', 3, 0), row("knit", 'f', 0, 7)}));
  ASSERT_TRUE(made->fabric);
  const int last = static_cast<int>(made->fabric->graph.loops.size()) - 1;
  EXPECT_GT(feet(*made, last - 7).at.y(), feet(*made, last).at.y() + 4 * d);
}

TEST(KnitoutFabric, TucksLieBehindTheLoopsTheyHangWith) {
  const auto made = make("tuck.k", lines({row("knit", 'f', 0, 4), row("knit", 'f', 4, 3), "tuck - f2 1\n",
                                          row("knit", 'f', 1, 0), row("knit", 'f', 0, 4)}));
  ASSERT_TRUE(made->fabric);
  const int held = 2, tuck = 7;
  ASSERT_EQ(made->fabric->graph.loops[tuck].kind, LoopKind::tuck);
  EXPECT_EQ(&head_of(*made, held), &head_of(*made, tuck));
  const auto middle = [&](int loop) {
    const auto points = points_of(made->fabric->fabric, loop);
    return points[points.size() / 2].z();
  };
  EXPECT_GT(middle(held) - middle(tuck), 0.8 * d);
}

/// A row of rib: even needles on the front bed, odd ones on the back bed.
std::string rib_row(int from, int to, const std::string& carriers) {
  std::string text;
  const int step = from <= to ? 1 : -1;
  for (int i = from; i != to + step; i += step)
    text += std::string("knit ") + (step > 0 ? "+ " : "- ") + (i % 2 ? "b" : "f") + std::to_string(i) + " " + carriers +
            "\n";
  return text;
}

TEST(KnitoutFabric, OfPlatedYarnsHasTheFirstNamedInFrontOrBehindOnBothBeds) {
  const std::string rib = lines({rib_row(0, 5, "1 2"), rib_row(5, 0, "1 2"), rib_row(0, 5, "1 2")});
  for (const Plating plating : {Plating::first_in_front, Plating::first_behind}) {
    const auto made = make("plated.k", rib, {}, plating);
    ASSERT_TRUE(made->fabric);
    const std::vector<Loop>& loops = made->fabric->graph.loops;
    for (int i = 0; i < static_cast<int>(loops.size()); i += 2) {
      ASSERT_EQ(loops[i].instruction, loops[i + 1].instruction);
      const int first = loops[i].carrier == 0 ? i : i + 1, second = i + (i + 1) - first;
      const auto a = points_of(made->fabric->fabric, first), b = points_of(made->fabric->fabric, second);
      const double ahead = a[a.size() / 2].z() - b[b.size() / 2].z();
      EXPECT_GT((plating == Plating::first_in_front ? 1 : -1) * ahead, 0.8 * d) << i;
    }
  }
}

YarnMaterials of_two_diameters(double first, double second) {
  YarnMaterials yarns;
  yarns.by_name.push_back({"1", {.name = "one", .diameter = first}, {}});
  yarns.by_name.push_back({"2", {.name = "two", .diameter = second}, {}});
  return yarns;
}

TEST(KnitoutFabric, OfPlatedRibHasInEverySegmentTheMaterialOfItsCarrier) {
  const auto made = make("plated.k", lines({rib_row(0, 5, "1 2"), rib_row(5, 0, "1 2"), rib_row(0, 5, "2")}),
                         of_two_diameters(0.3e-3, 0.5e-3));
  ASSERT_TRUE(made->fabric);
  const StitchGraph& graph = made->fabric->graph;
  const Fabric& fabric = made->fabric->fabric;
  ASSERT_EQ(fabric.yarns.size(), graph.yarns.size());
  std::set<int> carriers;
  for (int i = 0; i < fabric.segment_count(); ++i) {
    const int carrier = graph.yarns[static_cast<std::size_t>(fabric.segment(i).yarn)].carrier;
    const int loop = fabric.segment(i).stitch;
    EXPECT_EQ(fabric.material_of(i).name, carrier == 0 ? "one on 1" : "two on 2") << i;
    EXPECT_EQ(fabric.material_of(i).diameter, carrier == 0 ? 0.3e-3 : 0.5e-3) << i;
    EXPECT_TRUE(loop < 0 || graph.loops[static_cast<std::size_t>(loop)].carrier == carrier) << i;
    carriers.insert(carrier);
  }
  EXPECT_EQ(carriers, (std::set<int>{0, 1}));
  Results results;
  results.scene.fabric = fabric;
  const std::string path = testing::TempDir() + "/plated_rib.h5";
  write_hdf5(results, path);
  const Fabric stored = read_hdf5(path).scene.fabric;
  fs::remove(path);
  EXPECT_EQ(stored.materials, fabric.materials);
  for (int i = 0; i < fabric.segment_count(); ++i) EXPECT_EQ(stored.segment(i).material, fabric.segment(i).material);
  const std::string picture = fabric_svg(fabric, fabric.points, {});
  for (const char* name : {"one on 1", "two on 2"}) EXPECT_NE(picture.find(name), std::string::npos) << name;
}

TEST(KnitoutFabric, IsDrawnForTheThickestYarnThatIsKnitted) {
  const std::string one = lines({row("knit", 'f', 0, 3), row("knit", 'f', 3, 0)});
  const auto wale_of = [](const Made& made) { return (feet(made, 1).at - feet(made, 0).at).norm(); };
  const auto thin = make("thin.k", one, of_two_diameters(0.3e-3, 0.6e-3)),
             thick = make("thick.k", one, of_two_diameters(0.6e-3, 0.3e-3)),
             both = make("both.k", one + row("knit", 'f', 0, 3, "2"), of_two_diameters(0.3e-3, 0.6e-3));
  ASSERT_TRUE(thin->fabric && thick->fabric && both->fabric);
  EXPECT_EQ(thin->fabric->fabric.materials.size(), 1u) << "carrier 2 knits nothing";
  EXPECT_LT(wale_of(*thin), 0.99 * wale_of(*thick));
  EXPECT_NEAR(wale_of(*both), wale_of(*thick), 1e-6 * d);
}

TEST(KnitoutFabric, IsRefusedWhereACrossingIsWrong) {
  auto made = make("jersey.k", lines({row("knit", 'f', 0, 3), row("knit", 'f', 3, 0)}));
  ASSERT_TRUE(made->fabric);
  Fabric mirrored = made->fabric->fabric;
  mirrored.points.row(2) *= -1;
  Diagnostics say;
  passes::prove(made->fabric->graph, mirrored, made->fabric->crossings, say);
  ASSERT_EQ(say.all().size(), 1u);
  EXPECT_EQ(say.all().front().code, "L010");
  EXPECT_EQ(locate(say.all().front().span).line, 10) << "the last loop of the first row, the parent of the next";
}

double closest(const Fabric& fabric) {
  std::vector<std::pair<int, Vec3>> points;
  for (int i = 0; i < fabric.segment_count(); ++i)
    for (int k = 0; k < 4; ++k)
      points.push_back({i, combine(fabric.points, fabric.first_point(i), basis(k / 4.0).value)});
  double least = 1;
  for (std::size_t a = 0; a < points.size(); ++a)
    for (std::size_t b = a + 1; b < points.size(); ++b) {
      const bool beside = fabric.segment(points[a].first).yarn == fabric.segment(points[b].first).yarn &&
                          points[b].first - points[a].first < 5;
      if (!beside) least = std::min(least, (points[a].second - points[b].second).norm());
    }
  return least;
}

TEST(KnitoutFabric, IsWarnedOfAYarnTooThickForItsStitches) {
  const Source source{"tight.k", lines({row("knit", 'f', 0, 3), row("knit", 'f', 3, 0)})};
  KnitoutOptions options;
  options.stitch_lengths.otherwise = 5e-3;
  Diagnostics say;
  EXPECT_TRUE(compile_knitout(source, options, {}, 12, say));
  EXPECT_TRUE(say.counts().count("C020"));
}

TEST(KnitoutFabric, AsksOfEachYarnForItselfWhetherItIsTooThick) {
  const auto made = make("two.k", lines({row("knit", 'f', 0, 3, "1"), row("knit", 'f', 3, 0, "2")}),
                         of_two_diameters(0.3e-3, 0.6e-3));
  ASSERT_TRUE(made->fabric);
  EXPECT_EQ(made->say.counts().at("C020"), 1u);
  const auto& all = made->say.all();
  const auto warning = std::find_if(all.begin(), all.end(), [](const Diagnostic& one) { return one.code == "C020"; });
  EXPECT_EQ(locate(warning->span).line, 11) << "the first loop of carrier 2";
  EXPECT_NE(warning->message.find("two on 2"), std::string::npos) << warning->message;
}

TEST(KnitoutFabric, IsRefusedWhereNothingIsKnitted) {
  const auto made = make("nothing.k", head + "in 1\nout 1\n");
  EXPECT_FALSE(made->fabric);
  EXPECT_EQ(made->say.counts().count("L001"), 1u);
}

class KnitoutExample : public testing::TestWithParam<std::string> {};

TEST_P(KnitoutExample, IsPlacedWithEveryCrossingAndRoomBetweenItsYarns) {
  const fs::path path = fs::path(WALE_SOURCE_DIR) / "examples/05_knitout" / GetParam();
  const auto made = make(path.string(), read_text(path));
  ASSERT_TRUE(made->fabric);
  const auto held = Clasps(made->fabric->fabric, made->fabric->crossings).follow(made->fabric->fabric.points);
  EXPECT_EQ(std::count(held.begin(), held.end(), false), 0);
  EXPECT_GT(held.size(), made->fabric->graph.loops.size());
  EXPECT_GT(closest(made->fabric->fabric), 0.1 * d);
}

INSTANTIATE_TEST_SUITE_P(Every, KnitoutExample,
                         testing::Values("cable.k", "intarsia.k", "lace.k", "plating.k", "rib_cuff.k", "short_rows.k",
                                         "tube.k", "tuck.k"),
                         [](const auto& each) { return each.param.substr(0, each.param.find('.')); });

/// Real files that a machine would knit: all have the crossings that their graphs demand, and most no other ones.
TEST(KnitoutCorpus, IsPlacedAsItsGraphsDemand) {
  const fs::path corpus = shared_folder / "corpus";
  if (!fs::exists(corpus / "manifest.csv")) GTEST_SKIP() << "there is no " << corpus;
  std::set<std::string> entangled;
  int placed = 0;
  for (const Row& file : read_table(read_text(corpus / "manifest.csv"))) {
    if (std::stoi(file.at("loops")) > 3000) continue;
    const auto made = make(file.at("path"), read_text(corpus / file.at("path")));
    placed += made->fabric.has_value();
    for (const Diagnostic& each : made->say.all()) {
      EXPECT_NE(each.code, "L010") << file.at("path") << ": " << each.message;
      if (each.code == "L011") entangled.insert(fs::path(file.at("path")).filename().string());
    }
  }
  EXPECT_GE(placed, 51);
  EXPECT_EQ(entangled, (std::set<std::string>{"example-band-20x40.k", "fairisle-13x12.k", "icord-bind-off.k",
                                              "jersey-bindoff-13x12.k"}));
}

}  // namespace
}  // namespace wale
