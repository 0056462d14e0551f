#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "studio/accuracy/compare.hpp"
#include "studio/accuracy/convergence.hpp"
#include "studio/accuracy/sentences.hpp"
#include "tests/studio/shell.hpp"

namespace wale {
namespace {

TEST(ObservedOrder, IsThePowerOfTheSizeByWhichAnswersDiffer) {
  const auto answer = [](double h, double p) { return 3 + 0.7 * std::pow(h, p); };
  for (const double p : {0.5, 1.0, 2.0, 4.0}) {
    const double h1 = 1.0 / 12, h2 = 1.0 / 16, h3 = 1.0 / 32;
    EXPECT_NEAR(
        observed_order(h1, h2, h3, std::abs(answer(h1, p) - answer(h2, p)), std::abs(answer(h2, p) - answer(h3, p))), p,
        1e-9);
    EXPECT_NEAR(error_left(h2, h3, std::abs(answer(h2, p) - answer(h3, p)), p), 0.7 * std::pow(h3, p), 1e-12);
  }
  EXPECT_TRUE(std::isnan(observed_order(0.4, 0.2, 0.1, 1, 2))) << "answers that drift apart have no order";
}

TEST(ParetoFront, KeepsWhatNothingElseBeatsInBoth) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<WorkPrecision> runs{{3, 0.1}, {1, 0.5}, {2, 0.6}, {2, 0.2}, {9, 0.1}, {4, nan}};
  EXPECT_EQ(pareto_front(runs), (std::vector<std::size_t>{1, 3, 0}));
}

/// A pull whose stress is strain times `slope`.
Measured made(double slope, std::size_t samples) {
  Measured of;
  Curve curve;
  for (std::size_t i = 0; i < samples; ++i) {
    curve.strain.push_back(static_cast<double>(i) / static_cast<double>(samples - 1));
    curve.stress.push_back(slope * curve.strain.back());
  }
  of.curves = {{"", curve}};
  of.relaxed = {.course_spacing = 1e-3, .wale_spacing = 2e-3};
  of.diameter = 0.5e-3;
  of.yarn = Points::Random(3, 20) * 1e-3;
  return of;
}

TEST(Difference, IsThatOfTheStressOverThePeakWhateverTheSamples) {
  EXPECT_NEAR(difference(made(1.1, 5), made(1, 9))[of_stress], 0.1, 1e-12);
  EXPECT_NEAR(difference(made(1.1, 9), made(1, 5))[of_stress], 0.1, 1e-12);
}

TEST(Difference, OfPlacesDoesNotCountMotionOfTheWhole) {
  const Measured fine = made(1, 5);
  Measured moved = fine;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.2, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  moved.yarn = (turn * fine.yarn).colwise() + Vec3(1, 2, 3);
  EXPECT_NEAR(difference(moved, fine)[of_position], 0, 1e-9);
  moved.yarn.col(3) += Vec3(0, 0, 1e-4);
  EXPECT_NEAR(difference(moved, fine)[of_position], 1e-4 / std::sqrt(20) / 0.5e-3, 0.01);
}

/// Trials with segments of these sizes, whose stress is 1 + size².
Ladder ladder(const std::string& key, const std::vector<double>& sizes) {
  Ladder of{key, "segments", Knob::Kind::resolution, 2};
  for (const double size : sizes) {
    Trial trial{std::to_string(std::lround(1 / size)), size, size == 0.1};
    trial.found = made(1 + size * size, 5);
    trial.found->yarn = Points::Identity(3, 3);
    trial.cost.processor = 1 / size;
    of.trials.push_back(trial);
  }
  return of;
}

TEST(Compare, FindsOrdersAndTheErrorOfTheReferenceItself) {
  Study study;
  study.ladders = {ladder("segments", {0.2, 0.1, 0.05}), ladder("together", {0.1, 0.05, 0.025})};
  compare(study);
  const Ladder& segments = study.ladders[0];
  EXPECT_NEAR(*segments.observed_order, 2, 0.05);
  EXPECT_NEAR(study.reference_error[of_stress], 0.025 * 0.025, 1e-6);
  EXPECT_NEAR(segments.trials[0].error[of_stress], 0.04 - 0.025 * 0.025, 1e-4);
  EXPECT_NEAR(segments.trials[2].own_error[of_stress], 0.05 * 0.05, 1e-4) << "Richardson's for the finest";
  EXPECT_EQ(sentence(segments),
            "10 instead of 5 segments: error 3.7 % → 0.75 %, 2 times the time; 20 instead of 10 segments: error 0.75 % "
            "→ 0.25 %, 2 times the time");
}

TEST(Compare, SetsAsideWhatRestsElsewhere) {
  Study study;
  study.ladders = {ladder("segments", {0.2, 0.1, 0.05}), ladder("together", {0.1, 0.05, 0.025})};
  study.ladders[0].trials[0].found->relaxed.course_spacing *= 1.2;
  compare(study);
  EXPECT_TRUE(study.ladders[0].trials[0].rests_elsewhere);
  EXPECT_FALSE(study.ladders[0].trials[1].rests_elsewhere);
  EXPECT_FALSE(study.ladders[0].observed_order) << "two trials that are alike show no order";
}

class Accuracy : public testing::Test {
 protected:
  Accuracy() { scratch_.write("chart.yaml", "knit: 1\nwales: 1\nbands: [{stitch: jersey, courses: 1}]\n"); }
  test::Scratch scratch_;
  std::string scene_ = scratch_.write("scene.yaml", R"(scene: 1
fabric: {pattern: chart.yaml, periodic: true, segments_per_stitch: 12}
effects: {stretch: , bend: , contact: }
stages:
  - {name: tighten, duration: 1 s, tighten: 100 %, samples: 2}
  - {name: pull, duration: 1 s, pull: {along: wale, to: 10 %}, samples: 2}
)");
};

TEST_F(Accuracy, LeavesATableAnObjectAndAPage) {
  const test::Answer answer =
      test::wale({"accuracy", scene_, "-o", scratch_.path("out"), "--knob", "segments", "--knob", "law"});
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  const auto json = nlohmann::json::parse(test::read(scratch_.path("out/accuracy.json")));
  ASSERT_EQ(json["knobs"].size(), 3u);
  EXPECT_EQ(json["knobs"][2]["knob"], "together");
  EXPECT_GT(json["knobs"][0]["trials"][0]["error"]["stress"].get<double>(), 0);
  EXPECT_GT(json["knobs"][0]["trials"][0]["factorizations"].get<int>(), 0);
  EXPECT_TRUE(test::read(scratch_.path("out/accuracy.csv")).starts_with("knob,value,size,wall_s,processor_s,"));
  EXPECT_NE(test::read(scratch_.path("out/accuracy.html")).find("</svg>"), std::string::npos);
}

TEST_F(Accuracy, GoesOnWhereAStudyWasKilled) {
  const std::vector<std::string> study{"accuracy", scene_, "-o", scratch_.path("out"), "--knob", "segments"};
  ASSERT_EQ(test::wale(study).exit_code, 0);
  const auto whole = nlohmann::json::parse(test::read(scratch_.path("out/accuracy.json")));
  const std::string kept = test::read(scratch_.path("out/trials.jsonl"));
  scratch_.write("out/trials.jsonl", kept.substr(0, kept.size() - 40));  // as one that was killed while it wrote
  std::vector<std::string> resume = study;
  resume.insert(resume.end(), {"--resume", "--progress"});
  const test::Answer answer = test::wale(resume);
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 2) << "as written, and the last one:\n"
                                                                       << answer.err;
  auto resumed = nlohmann::json::parse(test::read(scratch_.path("out/accuracy.json")));
  for (std::size_t knob = 0; knob < 2; ++knob)
    for (std::size_t i = 0; i < whole["knobs"][knob]["trials"].size(); ++i)
      for (const char* what : {"found", "error", "own_error"})
        EXPECT_EQ(resumed["knobs"][knob]["trials"][i][what], whole["knobs"][knob]["trials"][i][what]);
}

TEST_F(Accuracy, DoesNotGoOnWithAnotherScene) {
  ASSERT_EQ(test::wale({"accuracy", scene_, "-o", scratch_.path("out"), "--knob", "law"}).exit_code, 0);
  const std::string kept = test::read(scratch_.path("out/trials.jsonl"));
  scratch_.write("chart.yaml", "knit: 1\nwales: 1\nbands: [{stitch: garter, courses: 2}]\n");
  const test::Answer answer = test::wale({"accuracy", scene_, "-o", scratch_.path("out"), "--resume"});
  EXPECT_EQ(answer.exit_code, 1);
  EXPECT_NE(answer.err.find("of another scene"), std::string::npos) << answer.err;
  EXPECT_EQ(test::read(scratch_.path("out/trials.jsonl")), kept);
}

TEST_F(Accuracy, SaysWhenThereIsNothingToGoOnWith) {
  const test::Answer answer = test::wale({"accuracy", scene_, "-o", scratch_.path("out"), "--resume"});
  EXPECT_EQ(answer.exit_code, 1);
  EXPECT_NE(answer.err.find("there is no study to go on with"), std::string::npos) << answer.err;
}

TEST_F(Accuracy, NamesTheKnobThatWasMeant) {
  const test::Answer answer = test::wale({"accuracy", scene_, "-o", scratch_.path("out"), "--knob", "segment"});
  EXPECT_EQ(answer.exit_code, 1);
  EXPECT_NE(answer.err.find("did you mean \"segments\"?"), std::string::npos) << answer.err;
}

}  // namespace
}  // namespace wale
