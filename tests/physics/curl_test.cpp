/// Fabrics without end that may curl.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/image.hpp"
#include "tests/support/cells.hpp"
#include "tests/support/make_fabric.hpp"
#include "tests/support/one_thread.hpp"

namespace wale {
namespace {

Stage bend_to(std::vector<double> curvatures, int samples) {
  Stage stage;
  stage.samples = samples;
  stage.deform = Deform{.curl = {Deform::How::driven, std::move(curvatures)}};
  return stage;
}

Stage let_go() {
  Stage stage;
  stage.samples = 1;
  return stage;
}

Stage pull_to(double strain, int samples) {
  Stage stage;
  stage.samples = samples;
  stage.pull = Pull{Along::wale, {strain}};
  return stage;
}

/// A column of the last stage.
std::vector<double> last(const Results& results, const std::string& name) {
  const std::vector<double>& stage = results.samples.find("stage")->values;
  const Column* column = results.samples.find(name);
  if (!column) throw std::runtime_error("there is no " + name);
  std::vector<double> values;
  for (std::size_t row = 0; row < stage.size(); ++row)
    if (stage[row] == stage.back()) values.push_back(column->values[row]);
  return values;
}

double curl_of(const std::vector<std::string>& picture, Curls curls) {
  return last(run_cell({.picture = picture, .tolerance = 1e-5, .curls = curls}, let_go()), "curvature").back();
}

class Curl : public ::testing::Test {
  OneThread one_;
};

/// M = EI κ of a straight yarn, on the distance to the next.
TEST_F(Curl, TakesTheMomentOfAYarnThatIsBent) {
  constexpr double across = 6e-3, up = 2e-3;
  constexpr int segments = 24;
  Results results;
  Fabric& fabric = results.scene.fabric;
  fabric.materials = {Material{}};
  fabric.cell = {{across, 0, 0}, {0, up, 0}, Curls::about_wales};
  add_yarn(fabric, straight_points({0, 0, 0}, {across, 0, 0}, segments), across / segments);
  results.scene.gauge.wales = results.scene.gauge.courses = 1;
  results.scene.gauge.thickness = 1e-3;
  Stage stage = bend_to({150, -80}, 4);
  stage.deform->wale.how = Deform::How::held;
  stage.effects = {Stretch{}, Bend{}, Contact{}};
  stage.solver = QuasiStatic{.tolerance = 1e-5};
  results.scene.stages = {stage};
  ASSERT_EQ(run(results, {}), Outcome::finished) << results.effort.failure;
  const std::vector<double> curvature = last(results, "curvature"), moment = last(results, "moment");
  const double rigidity = Material{}.bending_rigidity / up;
  for (std::size_t i = 0; i < curvature.size(); ++i)
    EXPECT_NEAR(moment[i], rigidity * curvature[i], 1e-3 * rigidity * 150) << curvature[i];
  EXPECT_NEAR(curvature[2], 150, 1e-9);
  EXPECT_NEAR(curvature[4], -80, 1e-9);
  // The mid-surface is that of the control points, and the yarn lies (κh)²/6 of the radius within them.
  const std::vector<double> course = last(results, "period.course");
  for (std::size_t i = 0; i < curvature.size(); ++i)
    EXPECT_NEAR(course[i], across * (1 + std::pow(curvature[i] * across / segments, 2) / 6), 1e-5 * across);
}

/// Jersey rolls to its face at its ends, and to its back at its sides.
TEST_F(Curl, OfJerseyIsThatOfRealJersey) {
  const double about_courses = curl_of({"k"}, Curls::about_courses), about_wales = curl_of({"k"}, Curls::about_wales);
  EXPECT_GT(about_courses, 100);
  EXPECT_LT(about_wales, -100);
  EXPECT_NEAR(curl_of({"p"}, Curls::about_courses), -about_courses, 0.01 * about_courses) << "seen from behind";
}

TEST_F(Curl, IsNoneWhereBothSidesAreAlike) {
  const double of_jersey = curl_of({"k"}, Curls::about_courses);
  for (const Curls curls : {Curls::about_courses, Curls::about_wales})
    for (const auto& picture : std::vector<std::vector<std::string>>{{"p", "k"}, {"kp"}})
      EXPECT_LT(std::abs(curl_of(picture, curls)), 0.02 * of_jersey) << picture[0] << static_cast<int>(curls);
}

/// As long as it does not meet itself behind the axis.
TEST_F(Curl, IsTheSameHoweverManyRepeatsBend) {
  const auto moments = [](const std::vector<std::string>& picture) {
    const CellRun run{.picture = picture, .tolerance = 1e-4, .curls = Curls::about_courses};
    return last(run_cell(run, bend_to({200, -200}, 8), true), "moment");
  };
  const std::vector<double> one = moments({"k"}), four = moments({"kk", "kk"});
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_NEAR(four[i], one[i], 2e-3 * std::abs(one.back())) << i;
}

TEST_F(Curl, StoresTheWorkOfItsMoment) {
  const Results results =
      run_cell({.picture = {"kk", "kk"}, .curls = Curls::about_courses}, bend_to({300, -300}, 60), true);
  const std::vector<double> curvature = last(results, "curvature"), moment = last(results, "moment"),
                            course = last(results, "period.course"), wale = last(results, "period.wale");
  std::vector<double> stored = last(results, "energy.stretch");
  for (const char* name : {"energy.bend", "energy.contact"}) {
    const std::vector<double> more = last(results, name);
    for (std::size_t i = 0; i < stored.size(); ++i) stored[i] += more[i];
  }
  double work = 0;
  const auto by_repeat = [&](std::size_t i) { return moment[i] * course[i] * wale[i]; };
  for (std::size_t i = 1; i < curvature.size(); ++i)
    work += (by_repeat(i) + by_repeat(i - 1)) / 2 * (curvature[i] - curvature[i - 1]);
  EXPECT_NEAR(work, stored.back() - stored.front(), 0.01 * work);
}

TEST_F(Curl, IsAsAFlatFabricWhereItIsHeldFlat) {
  const auto pulled = [](Curls curls) {
    Stage pull = pull_to(0.4, 4);
    pull.pull.reset();
    pull.deform = Deform{.wale = {Deform::How::driven, {0.4}}, .curl = {Deform::How::held, {}}};
    CellRun of{.picture = {"k"}, .tolerance = 1e-4, .curls = curls};
    return run_cell(of, pull, curls != Curls::never);
  };
  const std::vector<double> flat = last(pulled(Curls::never), "stress.wale");
  for (const Curls curls : {Curls::about_courses, Curls::about_wales}) {
    const std::vector<double> held = last(pulled(curls), "stress.wale");
    for (std::size_t i = 0; i < flat.size(); ++i) EXPECT_NEAR(held[i], flat[i], 2e-3 * flat.back()) << i;
  }
}

}  // namespace
}  // namespace wale
