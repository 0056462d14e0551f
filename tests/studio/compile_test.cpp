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

TEST(Compile, RefusesASuffixThatIsNotThereYet) {
  const Scratch scratch;
  const Answer answer = wale({"compile", scratch.write("rib.yaml", jersey), "-o", scratch.path("rib.k")});
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
