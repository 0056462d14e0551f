#include "sim/results/vtk.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <set>

#include "sim/polyline.hpp"
#include "sim/results/file.hpp"
#include "sim/results/stretch_strain.hpp"
#include "tests/sim/results/made_results.hpp"

namespace wale {
namespace {

/// A reader of its own: what stands in a tag, and the bytes that an array points to.
class File {
 public:
  explicit File(std::string text) : text_(std::move(text)), data_(text_.find("encoding=\"raw\"")) {
    data_ = text_.find('_', data_) + 1;
  }
  std::size_t number(const std::string& attribute) const {
    return std::stoul(text_.substr(text_.find(attribute + "=\"") + attribute.size() + 2));
  }
  template <class T>
  std::vector<T> array(const std::string& name, const std::string& type) const {
    const std::size_t tag = text_.find("<DataArray type=\"" + type + "\" Name=\"" + name + "\"");
    if (tag >= data_) return {};
    const std::size_t from = data_ + std::stoul(text_.substr(text_.find("offset=\"", tag) + 8));
    std::uint64_t size = 0;
    std::memcpy(&size, text_.data() + from, sizeof size);
    std::vector<T> values(size / sizeof(T));
    std::memcpy(values.data(), text_.data() + from + sizeof size, size);
    return values;
  }
  std::vector<float> floats(const std::string& name) const { return array<float>(name, "Float32"); }
  std::vector<std::int32_t> integers(const std::string& name) const { return array<std::int32_t>(name, "Int32"); }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::size_t data_;
};

Vec3 at(const std::vector<float>& values, std::size_t i) {
  return {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
}

TEST(Vtk, LinesAreTheSplineWithItsRadius) {
  const testing::MadeJersey made = testing::made_jersey(3, 2);
  const File file(vtp(made.fabric, made.fabric.points, {.shape = YarnShape::lines, .per_segment = 4}));
  const std::size_t count = 4 * 48 + 1;
  ASSERT_EQ(file.number("NumberOfPoints"), 2 * count);
  EXPECT_EQ(file.number("NumberOfLines"), 2U);
  EXPECT_EQ(file.number("NumberOfPolys"), 0U);
  EXPECT_EQ(file.integers("offsets"), (std::vector<std::int32_t>{193, 386}));
  EXPECT_EQ(file.integers("yarn"), (std::vector<std::int32_t>{0, 1}));
  const Points axis = polyline(made.fabric, made.fabric.points, 48, 95, 4);
  const std::vector<float> points = file.floats("Points"), radius = file.floats("radius");
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_LT((at(points, count + i) - axis.col(static_cast<Eigen::Index>(i))).norm(), 1e-8);
    EXPECT_FLOAT_EQ(radius[i], 0.262e-3F);
  }
  EXPECT_EQ(file.integers("stitch")[count], 3);
}

TEST(Vtk, TubesAreClosedSurfacesOfTheYarnsDiameter) {
  const testing::MadeJersey made = testing::made_jersey(2, 1);
  const File file(vtp(made.fabric, made.fabric.points, {.per_segment = 2, .sides = 6}));
  const std::size_t rings = 2 * 32 + 1;
  ASSERT_EQ(file.number("NumberOfPoints"), 6 * rings);
  EXPECT_EQ(file.number("NumberOfPolys"), 6 * (rings - 1) + 2);
  const std::vector<float> points = file.floats("Points"), normals = file.floats("Normals");
  const Points axis = polyline(made.fabric, made.fabric.points, 0, 31, 2);
  for (std::size_t i = 0; i < 6 * rings; ++i) {
    const Vec3 centre = axis.col(static_cast<Eigen::Index>(i / 6));
    EXPECT_NEAR((at(points, i) - centre).norm(), made.diameter / 2, 1e-8);
    EXPECT_LT((at(points, i) - centre - made.diameter / 2 * at(normals, i)).norm(), 1e-8);
  }
  // Closed and turned outwards: every edge is run through once either way, and the enclosed volume is positive.
  std::multiset<std::pair<int, int>> edges;
  const std::vector<std::int32_t> corners = file.integers("connectivity"), ends = file.integers("offsets");
  double volume = 0;
  for (std::size_t cell = 0, from = 0; cell < ends.size(); from = static_cast<std::size_t>(ends[cell++])) {
    const std::size_t to = static_cast<std::size_t>(ends[cell]);
    for (std::size_t k = from; k < to; ++k) {
      const std::int32_t a = corners[k], b = corners[k + 1 < to ? k + 1 : from];
      edges.insert({a, b});
      volume += at(points, corners[from]).dot(at(points, a).cross(at(points, b))) / 6;
    }
  }
  for (const auto& [a, b] : edges) {
    ASSERT_EQ(edges.count({a, b}), 1U);
    ASSERT_EQ(edges.count({b, a}), 1U);
  }
  double length = 0;
  for (Eigen::Index i = 1; i < axis.cols(); ++i) length += (axis.col(i) - axis.col(i - 1)).norm();
  const double hexagon = 1.5 * std::sqrt(3.0) * made.diameter * made.diameter / 4;
  EXPECT_NEAR(volume, hexagon * length, 0.02 * hexagon * length);
}

TEST(Vtk, TubesDoNotTwist) {
  const testing::MadeJersey made = testing::made_jersey(2, 1);
  const File file(vtp(made.fabric, made.fabric.points, {}));
  const std::vector<float> normals = file.floats("Normals");
  for (std::size_t i = 8; i < normals.size() / 3; ++i) ASSERT_GT(at(normals, i).dot(at(normals, i - 8)), 0.9) << i;
}

/// A circle of 40 segments, radius 10 mm, drawn out by 5 %.
TEST(Vtk, TellsStrainEnergyAndCurvature) {
  Fabric fabric;
  fabric.materials = {Material{}};
  fabric.yarns = {{0, 0, 40}};
  fabric.points.resize(3, 43);
  const double step = 2 * std::numbers::pi / 40, fit = (4 + 2 * std::cos(step)) / 6;
  for (int i = 0; i < 43; ++i) fabric.points.col(i) = 0.01 / fit * Vec3(std::cos(step * i), std::sin(step * i), 0);
  for (int i = 0; i < 40; ++i) fabric.segments.push_back({0, 0, i, 1, 0.01 * step / 1.05});
  const File file(vtp(fabric, fabric.points, {.shape = YarnShape::lines, .rest = 1}));
  for (const float strain : file.floats("strain")) EXPECT_NEAR(strain, 0.05, 1e-4);
  for (const float energy : file.floats("stretch_energy")) EXPECT_NEAR(energy, 0.5 * 68.1 * 0.05 * 0.05, 1e-3);
  for (const float curvature : file.floats("curvature")) EXPECT_NEAR(curvature, 100, 1);
  EXPECT_NE(file.text().find("<PointData Scalars=\"stretch_energy\">"), std::string::npos);
}

TEST(Vtk, ListsEveryFrameOnceAtItsTime) {
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "vtk_frames";
  Results results = testing::made_results();
  // Two stages: the second begins where the first ends.
  const double times[] = {0, 0.5, 1, 0, 1, 2};
  for (std::size_t i = 0; i < 6; ++i) {
    results.snapshots[i].stage = i < 3 ? 0 : 1;
    results.snapshots[i].sample = static_cast<int>(i % 3);
    results.snapshots[i].state.t = times[i];
  }
  write_frames(results, folder.string());
  const std::string list = read_file((folder / "frames.pvd").string());
  std::vector<std::string> found;
  for (std::size_t tag = list.find("timestep=\""); tag != std::string::npos; tag = list.find("timestep=\"", tag + 1))
    found.push_back(list.substr(tag + 10, list.find('"', tag + 10) - tag - 10));
  EXPECT_EQ(found, (std::vector<std::string>{"0", "0.5", "1", "2", "3"}));
  for (int i = 0; i < 5; ++i) {
    const std::string name = "frames/frame_000" + std::to_string(i) + ".vtp";
    EXPECT_NE(list.find(name), std::string::npos);
    EXPECT_GT(std::filesystem::file_size(folder / name), 1000U);
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "frames/frame_0005.vtp"));
  std::filesystem::remove_all(folder);
}

TEST(StretchStrain, KnowsTheRestLengthsOfASnapshot) {
  Scene scene;
  scene.stages.resize(3);
  scene.stages[0].tighten = 0.5;
  scene.stages[0].duration = 2;
  scene.stages[2].tighten = 1;
  EXPECT_EQ(rest_lengths_at(scene, {0, 0, {}}), RestLengths(0));
  EXPECT_EQ(rest_lengths_at(scene, {.stage = 0, .sample = 1, .state = {.t = 1, .q = {}, .v = {}}}), RestLengths(0.25));
  EXPECT_EQ(rest_lengths_at(scene, {1, 0, {}}), RestLengths(0.5));
  EXPECT_EQ(rest_lengths_at(scene, {.stage = 2, .sample = 1, .state = {.t = 1, .q = {}, .v = {}}}), RestLengths(1));
  EXPECT_EQ(rest_lengths_at({}, {0, 0, {}}), RestLengths(1));
}

}  // namespace
}  // namespace wale
