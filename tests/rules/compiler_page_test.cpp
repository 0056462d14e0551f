#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "compiler/passes.hpp"

namespace wale {
namespace {

std::string read(const std::string& path) {
  std::ifstream file(std::string(WALE_SOURCE_DIR) + "/" + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(CompilerPage, ShowsWhatTheCompilerPrints) {
  const std::string page = read("docs/compiler.md"), fence = "```\n";
  const Source source{"flat.yaml", read("tests/golden/ir/flat.yaml")};
  Diagnostics say;
  const auto chart = passes::parse_chart(source, {}, say);
  ASSERT_TRUE(chart);
  const Program program = passes::lower_chart(*chart, say).value();
  const StitchGraph graph = passes::knit(program, say).value();
  const double d = chart->yarns.front().material.diameter;
  const Arrangement layout = passes::arrange(graph, large_enough(d, longest_stitch(graph)), d);
  EXPECT_TRUE(say.all().empty());
  EXPECT_NE(page.find("```yaml\n" + source.text + fence), std::string::npos);
  for (const std::string& shown :
       {print(*chart), print(program), print(graph), print(layout), read("tests/golden/ir/tube.k")})
    EXPECT_NE(page.find("\n" + fence + shown + fence), std::string::npos) << shown;
}

}  // namespace
}  // namespace wale
