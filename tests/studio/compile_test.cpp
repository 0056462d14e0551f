#include <gtest/gtest.h>

#include <cstring>

#include "tests/studio/shell.hpp"

namespace wale::test {
namespace {

const std::string jersey =
    "knit: 1\nwales: 3\nyarns: {main: {material: acrylic_16_2}}\nbands: [{stitch: rib 1x1, courses: 4}]\n";

TEST(Compile, ShowsTheChartAsAPicture) {
  const Scratch scratch;
  const Answer answer = wale({"compile", scratch.write("rib.yaml", jersey), "--show", "chart"});
  EXPECT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_NE(answer.out.find("kpk"), std::string::npos) << answer.out;
}

TEST(Compile, ChangesAChartsSizeFromTheCommandLine) {
  const Scratch scratch;
  const Answer answer = wale({"compile", scratch.write("rib.yaml", jersey), "--show", "chart", "--wales", "5"});
  EXPECT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_NE(answer.out.find("kpkpk"), std::string::npos) << answer.out;
}

TEST(Compile, WritesABinaryCurveCollectionWhoseHeaderCountsItsPoints) {
  const Scratch scratch;
  const std::string out = scratch.path("rib.bcc");
  const Answer answer = wale({"compile", scratch.write("rib.yaml", jersey), "-o", out});
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  const std::string bytes = read(out);
  ASSERT_GT(bytes.size(), 64u);
  EXPECT_EQ(bytes.substr(0, 4), "BCC\x44");
  std::uint64_t curves = 0, points = 0;
  std::memcpy(&curves, bytes.data() + 8, 8);
  std::memcpy(&points, bytes.data() + 16, 8);
  EXPECT_EQ(curves, 1u);
  EXPECT_EQ(bytes.size(), 64 + 4 * curves + 12 * points);
}

TEST(Compile, WritesEverySuffixItPromises) {
  const Scratch scratch;
  const std::string chart = scratch.write("rib.yaml", jersey);
  for (const char* name : {"rib.h5", "rib.vtp", "rib.obj", "rib.bcc", "rib.svg"}) {
    const Answer answer = wale({"compile", chart, "-o", scratch.path(name)});
    EXPECT_EQ(answer.exit_code, 0) << answer.err;
    EXPECT_GT(read(scratch.path(name)).size(), 100u) << name;
  }
  EXPECT_EQ(scratch.names().size(), 6u) << "nothing partial stays behind";
}

TEST(Compile, WritesAProgramThatItCanRead) {
  const Scratch scratch;
  const std::string chart = scratch.write("rib.yaml", jersey), program = scratch.path("rib.k");
  for (const char* machine : {"kniterate", "swg"}) {
    const Answer written = wale({"compile", chart, "-o", program, "--machine", machine});
    ASSERT_EQ(written.exit_code, 0) << written.err;
    const Answer shown = wale({"compile", program, "--show", "program"});
    EXPECT_EQ(shown.exit_code, 0) << shown.err;
    EXPECT_EQ(wale({"check", program}).exit_code, 0);
  }
  EXPECT_EQ(wale({"compile", chart, "-o", program, "--machine", "loom"}).exit_code, 1);
}

TEST(Compile, CropsAKnitoutFileAndSetsItsStitchLengths) {
  const Scratch scratch;
  const std::string program = scratch.write("strip.k",
                                            ";!knitout-2\n;;Carriers: 1\nin 1\nx-stitch-number 5\nknit + f0 1\nknit + "
                                            "f1 1\nknit - f1 1\nknit - f0 1\nout 1\n");
  const Answer cropped = wale({"compile", program, "--show", "graph", "--courses", "2", "--needles", "-1-0"});
  EXPECT_EQ(cropped.out, "loop 0: knit - f0 yarn 1 pass 1 held\nyarn 1: 1 loops\n") << cropped.err;
  EXPECT_EQ(wale({"compile", program, "--show", "graph", "--stitch-length", "5 = 9 mm"}).exit_code, 0);
  EXPECT_EQ(wale({"compile", program, "--show", "graph", "--stitch-length", "5 = 9 kg"}).exit_code, 1);
  EXPECT_EQ(wale({"compile", program, "--show", "graph", "--courses", "4-2"}).exit_code, 1);
  EXPECT_EQ(wale({"compile", program, "--show", "graph", "--courses", "9"}).exit_code, 1) << "nothing is left";
}

TEST(Compile, LaysTheFirstOfSeveralCarriersInFrontOrBehind) {
  const Scratch scratch;
  const std::string program =
      scratch.write("plated.k", ";!knitout-2\n;;Carriers: 1 2\nin 1\nin 2\nknit + f0 1 2\nout 1\nout 2\n");
  const auto first_loop = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"compile", program, "--show", "graph"});
    const std::string shown = wale(words).out;
    return shown.substr(0, shown.find('\n'));
  };
  EXPECT_EQ(first_loop({}), "loop 0: knit + f0 yarn 1 pass 0 held");
  EXPECT_EQ(first_loop({"--plating", "first_in_front"}), "loop 0: knit + f0 yarn 1 pass 0 held");
  EXPECT_EQ(first_loop({"--plating", "first_behind"}), "loop 0: knit + f0 yarn 2 pass 0 held");
  EXPECT_EQ(wale({"check", program, "--plating", "first_behind"}).exit_code, 0);
  EXPECT_EQ(wale({"check", program, "--plating", "behind"}).exit_code, 1);
  EXPECT_EQ(
      wale({"compile", scratch.write("rib.yaml", jersey), "--show", "chart", "--plating", "first_behind"}).exit_code,
      1);
}

TEST(Compile, RefusesASuffixThatIsNotThereYet) {
  const Scratch scratch;
  const Answer answer = wale({"compile", scratch.write("rib.yaml", jersey), "-o", scratch.path("rib.stl")});
  EXPECT_EQ(answer.exit_code, 1);
  EXPECT_EQ(scratch.names(), std::vector<std::string>{"rib.yaml"});
}

TEST(Compile, SaysWhenTheOutputCannotBeWritten) {
  const Scratch scratch;
  const Answer answer = wale({"compile", scratch.write("rib.yaml", jersey), "-o", scratch.path("no/such/rib.obj")});
  EXPECT_EQ(answer.exit_code, 1);
  EXPECT_NE(answer.first_error_line().find("error: cannot be written"), std::string::npos) << answer.err;
}

}  // namespace
}  // namespace wale::test
