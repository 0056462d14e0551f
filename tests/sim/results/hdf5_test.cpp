#include "sim/results/hdf5.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "sim/results/file.hpp"
#include "tests/sim/results/made_results.hpp"

namespace wale {
namespace {

namespace fs = std::filesystem;

class Hdf5 : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  fs::path folder_ = fs::path(::testing::TempDir()) / ::testing::UnitTest::GetInstance()->current_test_info()->name();
};

bool same_bits(const double* a, const double* b, std::size_t count) {
  return count == 0 || std::memcmp(a, b, count * sizeof(double)) == 0;
}
bool same_bits(const Points& a, const Points& b) {
  return a.cols() == b.cols() && same_bits(a.data(), b.data(), static_cast<std::size_t>(a.size()));
}

void expect_same(const Table& a, const Table& b) {
  ASSERT_EQ(a.columns.size(), b.columns.size());
  for (std::size_t i = 0; i < a.columns.size(); ++i) {
    EXPECT_EQ(a.columns[i].name, b.columns[i].name);
    EXPECT_EQ(a.columns[i].unit, b.columns[i].unit);
    ASSERT_EQ(a.columns[i].values.size(), b.columns[i].values.size());
    EXPECT_TRUE(same_bits(a.columns[i].values.data(), b.columns[i].values.data(), a.rows())) << a.columns[i].name;
  }
}

void expect_same(const Fabric& a, const Fabric& b) {
  EXPECT_EQ(a.source, b.source);
  EXPECT_EQ(a.materials, b.materials);
  ASSERT_EQ(a.yarns.size(), b.yarns.size());
  for (std::size_t i = 0; i < a.yarns.size(); ++i) {
    EXPECT_EQ(a.yarns[i].first_point, b.yarns[i].first_point);
    EXPECT_EQ(a.yarns[i].first_segment, b.yarns[i].first_segment);
    EXPECT_EQ(a.yarns[i].segments, b.yarns[i].segments);
  }
  ASSERT_EQ(a.segments.size(), b.segments.size());
  for (std::size_t i = 0; i < a.segments.size(); ++i) {
    EXPECT_EQ(a.segments[i].yarn, b.segments[i].yarn);
    EXPECT_EQ(a.segments[i].material, b.segments[i].material);
    EXPECT_EQ(a.segments[i].stitch, b.segments[i].stitch);
    EXPECT_EQ(a.segments[i].length, b.segments[i].length);
    EXPECT_EQ(a.segments[i].knitted, b.segments[i].knitted);
    EXPECT_EQ(a.segments[i].line, b.segments[i].line);
    EXPECT_EQ(a.segments[i].column, b.segments[i].column);
  }
  EXPECT_TRUE(same_bits(a.points, b.points));
  ASSERT_EQ(a.cell.has_value(), b.cell.has_value());
  if (!a.cell) return;
  EXPECT_EQ(a.cell->course, b.cell->course);
  EXPECT_EQ(a.cell->wale, b.cell->wale);
}

void expect_same_report(const Results& a, const Results& b) {
  EXPECT_EQ(a.manifest.version, b.manifest.version);
  EXPECT_EQ(a.manifest.host, b.manifest.host);
  EXPECT_EQ(a.manifest.when, b.manifest.when);
  EXPECT_EQ(a.manifest.threads, b.manifest.threads);
  EXPECT_EQ(a.manifest.accuracy, b.manifest.accuracy);
  EXPECT_EQ(a.manifest.refinements, b.manifest.refinements);
  ASSERT_EQ(a.manifest.sources.size(), b.manifest.sources.size());
  for (std::size_t i = 0; i < a.manifest.sources.size(); ++i) {
    EXPECT_EQ(a.manifest.sources[i].name, b.manifest.sources[i].name);
    EXPECT_EQ(a.manifest.sources[i].text, b.manifest.sources[i].text);
  }
  ASSERT_EQ(a.phases.size(), b.phases.size());
  for (std::size_t i = 0; i < a.phases.size(); ++i) {
    EXPECT_EQ(a.phases[i].name, b.phases[i].name);
    EXPECT_EQ(a.phases[i].seconds, b.phases[i].seconds);
  }
  EXPECT_EQ(std::memcmp(&a.relaxed, &b.relaxed, sizeof(Sizes)), 0);
  EXPECT_EQ(a.effort.accepted, b.effort.accepted);
  EXPECT_EQ(a.effort.rejected, b.effort.rejected);
  EXPECT_EQ(a.effort.evaluations, b.effort.evaluations);
  EXPECT_EQ(a.effort.spared, b.effort.spared);
  EXPECT_EQ(a.effort.factorizations, b.effort.factorizations);
  EXPECT_EQ(a.effort.retries.halved, b.effort.retries.halved);
  EXPECT_EQ(a.effort.retries.continued, b.effort.retries.continued);
  EXPECT_EQ(a.effort.retries.damped, b.effort.retries.damped);
  EXPECT_EQ(a.effort.retries.detoured, b.effort.retries.detoured);
  EXPECT_EQ(a.effort.failure, b.effort.failure);
  EXPECT_EQ(a.topology.expected, b.topology.expected);
  EXPECT_EQ(a.topology.found, b.topology.found);
  EXPECT_EQ(a.contact_samples, b.contact_samples);
  EXPECT_EQ(a.warnings, b.warnings);
  EXPECT_EQ(a.complete, b.complete);
}

void expect_same(const Results& a, const Results& b) {
  expect_same_report(a, b);
  EXPECT_EQ(a.scene.name, b.scene.name);
  expect_same(a.scene.fabric, b.scene.fabric);
  EXPECT_EQ(a.scene.gauge.wale_ends, b.scene.gauge.wale_ends);
  EXPECT_EQ(a.scene.gauge.course_ends, b.scene.gauge.course_ends);
  EXPECT_EQ(a.scene.gauge.wales, b.scene.gauge.wales);
  EXPECT_EQ(a.scene.gauge.courses, b.scene.gauge.courses);
  EXPECT_EQ(a.scene.gauge.thickness, b.scene.gauge.thickness);
  EXPECT_EQ(a.scene.crossings, b.scene.crossings);
  ASSERT_EQ(a.scene.clamps.size(), b.scene.clamps.size());
  for (std::size_t i = 0; i < a.scene.clamps.size(); ++i) {
    EXPECT_EQ(a.scene.clamps[i].yarn, b.scene.clamps[i].yarn);
    EXPECT_EQ(a.scene.clamps[i].at_end, b.scene.clamps[i].at_end);
    EXPECT_EQ(a.scene.clamps[i].position, b.scene.clamps[i].position);
    EXPECT_EQ(a.scene.clamps[i].direction, b.scene.clamps[i].direction);
  }
  expect_same(a.samples, b.samples);
  ASSERT_EQ(a.snapshots.size(), b.snapshots.size());
  for (std::size_t i = 0; i < a.snapshots.size(); ++i) {
    const Snapshot &one = a.snapshots[i], &other = b.snapshots[i];
    EXPECT_EQ(one.stage, other.stage);
    EXPECT_EQ(one.sample, other.sample);
    EXPECT_EQ(one.state.t, other.state.t);
    EXPECT_EQ(one.state.step, other.state.step);
    EXPECT_TRUE(same_bits(one.state.q, other.state.q));
    EXPECT_TRUE(same_bits(one.state.v, other.state.v));
    EXPECT_TRUE(same_bits(one.state.a, other.state.a));
  }
}

TEST_F(Hdf5, GivesResultsBackBitForBit) {
  const Results results = testing::made_results();
  write_hdf5(results, path("a.h5"));
  expect_same(results, read_hdf5(path("a.h5")));
  EXPECT_FALSE(fs::exists(path("a.h5.part")));
}

TEST_F(Hdf5, GivesThePeriodsOfACellBack) {
  Results results = testing::made_results();
  results.scene.fabric.cell = {{0.1 + 0.2, 0, 0}, {1e-4, 2e-3, 0}};
  write_hdf5(results, path("a.h5"));
  expect_same(results, read_hdf5(path("a.h5")));
}

TEST_F(Hdf5, GivesTheAccelerationsBackThatSomeSnapshotsKnow) {
  Results results = testing::made_results();
  State& last = results.snapshots.back().state;
  last.a = Points::Constant(3, last.q.cols(), 0.1 + 0.2);
  write_hdf5(results, path("a.h5"));
  expect_same(results, read_hdf5(path("a.h5")));
}

TEST_F(Hdf5, GivesEmptyResultsBack) {
  write_hdf5({}, path("a.h5"));
  expect_same(Results(), read_hdf5(path("a.h5")));
}

TEST_F(Hdf5, SavesTwiceOverTheSameFile) {
  Results results = testing::made_results();
  write_hdf5(results, path("a.h5"));
  results.snapshots.pop_back();
  results.complete = false;
  write_hdf5(results, path("a.h5"));
  expect_same(results, read_hdf5(path("a.h5")));
}

TEST_F(Hdf5, KeepsTheOldFileWhenAWriteFails) {
  Results results = testing::made_results();
  write_hdf5(results, path("a.h5"));
  const std::string before = read_file(path("a.h5"));
  results.snapshots.back().state.q.conservativeResize(3, 5);
  EXPECT_THROW(write_hdf5(results, path("a.h5")), std::invalid_argument);
  results = testing::made_results();
  results.manifest.sources[0].text = std::string("cut\0here", 8);
  EXPECT_THROW(write_hdf5(results, path("a.h5")), std::runtime_error);
  EXPECT_EQ(read_file(path("a.h5")), before);
  EXPECT_FALSE(fs::exists(path("a.h5.part")));
}

/// What a call throws as E; fails the test otherwise.
template <class E, class Call>
std::string message(Call call) {
  try {
    call();
  } catch (const E& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing thrown";
  return {};
}

TEST_F(Hdf5, NamesThePathThatItCannotWriteOrRead) {
  const std::string nowhere = path("no/such/a.h5");
  EXPECT_NE(message<std::system_error>([&] { write_hdf5({}, nowhere); }).find(nowhere), std::string::npos);
  EXPECT_NE(message<std::system_error>([&] { read_hdf5(nowhere); }).find(nowhere), std::string::npos);
  EXPECT_NE(message<std::system_error>([&] { read_hdf5(folder_.string()); }).find(folder_.string()), std::string::npos);
}

TEST_F(Hdf5, RefusesFilesOfAnotherKindAndDamagedOnes) {
  std::ofstream(path("text.h5")) << "stitches\n";
  EXPECT_NE(message<std::runtime_error>([&] { read_hdf5(path("text.h5")); }).find("text.h5"), std::string::npos);
  const testing::MadeJersey made = testing::made_jersey(2, 2);
  write_fabric_hdf5(made.fabric, path("fabric.h5"));
  EXPECT_NE(message<std::runtime_error>([&] { read_hdf5(path("fabric.h5")); }).find("wale fabric"), std::string::npos);
  write_hdf5(testing::made_results(), path("cut.h5"));
  fs::resize_file(path("cut.h5"), fs::file_size(path("cut.h5")) / 2);
  EXPECT_NE(message<std::runtime_error>([&] { read_hdf5(path("cut.h5")); }).find("cut.h5"), std::string::npos);
}

}  // namespace
}  // namespace wale
