#include "sim/results/vtk.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <stdexcept>
#include <system_error>

#include "sim/results/file.hpp"
#include "sim/results/shown_fabric.hpp"
#include "sim/results/stretch_strain.hpp"
#include "sim/results/vtk_file.hpp"
#include "sim/spline.hpp"

namespace wale {
namespace {

/// A place on a yarn, and what is told of it.
struct Station {
  Vec3 position, tangent;
  double radius = 0, strain = 0, stretch_energy = 0, curvature = 0;
  int material = 0, stitch = 0;
};

/// Strain at parameter s of a segment, linear between the middles of segments, where it is known.
double strain_at(const std::vector<double>& strains, const Yarn& yarn, int segment, double s) {
  const int last = yarn.first_segment + yarn.segments - 1;
  const int other = std::clamp(segment + (s < 0.5 ? -1 : 1), yarn.first_segment, last);
  const double share = std::abs(s - 0.5);
  return (1 - share) * strains[static_cast<std::size_t>(segment)] + share * strains[static_cast<std::size_t>(other)];
}

Station station(const Fabric& fabric, const Points& q, const std::vector<double>& strains, int segment, double s) {
  const Basis at = basis(s);
  const int first = fabric.first_point(segment);
  const Vec3 slope = combine(q, first, at.first), bend = combine(q, first, at.second);
  const double length = slope.norm();
  const Material& material = fabric.material_of(segment);
  Station made;
  made.position = combine(q, first, at.value);
  made.tangent = length > 0 ? Vec3(slope / length) : Vec3(Vec3::UnitX());
  made.radius = material.diameter / 2;
  made.strain = strain_at(strains, fabric.yarns[static_cast<std::size_t>(fabric.segment(segment).yarn)], segment, s);
  made.stretch_energy = 0.5 * material.axial_stiffness * made.strain * made.strain;
  made.curvature = length > 0 ? slope.cross(bend).norm() / (length * length * length) : 0;
  made.material = fabric.segment(segment).material;
  made.stitch = fabric.segment(segment).stitch;
  return made;
}

std::vector<Station> stations(const Fabric& fabric, const Points& q, const std::vector<double>& strains,
                              const Yarn& yarn, int per_segment) {
  std::vector<Station> all;
  for (int i = 0; i < yarn.segments; ++i)
    for (int k = 0; k < per_segment; ++k)
      all.push_back(station(fabric, q, strains, yarn.first_segment + i, static_cast<double>(k) / per_segment));
  if (yarn.segments > 0) all.push_back(station(fabric, q, strains, yarn.first_segment + yarn.segments - 1, 1));
  return all;
}

/// The arrays of the file under way.
class Surface {
 public:
  explicit Surface(const VtkOptions& options) : options_(options) {}

  void add_line(const std::vector<Station>& yarn, int index) {
    for (const Station& at : yarn) {
      cells_.push_back(next_point());
      add_point(at.position, at);
    }
    close_cell(index);
  }

  void add_tube(const std::vector<Station>& yarn, int index) {
    const int sides = options_.sides, first = next_point(), rings = static_cast<int>(yarn.size());
    Vec3 normal = yarn.front().tangent.unitOrthogonal();
    for (const Station& at : yarn) {
      // Carried along without twist: what the turn of the tangent leaves of the last normal.
      normal -= at.tangent.dot(normal) * at.tangent;
      normal = normal.norm() > 1e-6 ? Vec3(normal.normalized()) : Vec3(at.tangent.unitOrthogonal());
      add_ring(at, normal, at.tangent.cross(normal));
    }
    for (int ring = 0; ring + 1 < rings; ++ring)
      for (int side = 0; side < sides; ++side) {
        const int a = first + ring * sides + side, b = first + ring * sides + (side + 1) % sides;
        cells_.insert(cells_.end(), {a, b, b + sides, a + sides});
        close_cell(index);
      }
    for (int side = sides - 1; side >= 0; --side) cells_.push_back(first + side);
    close_cell(index);
    for (int side = 0; side < sides; ++side) cells_.push_back(first + (rings - 1) * sides + side);
    close_cell(index);
  }

  std::string finish() const {
    const bool is_tube = options_.shape == YarnShape::tubes;
    const std::string cells = is_tube ? "Polys" : "Lines";
    VtkFile file;
    file.add("Points", "Points", points_, 3);
    file.add(cells, "connectivity", cells_);
    file.add(cells, "offsets", ends_);
    file.add("PointData", "stretch_energy", stretch_energy_);
    file.add("PointData", "strain", strain_);
    file.add("PointData", "curvature", curvature_);
    if (is_tube) file.add("PointData", "Normals", normals_, 3);
    if (!is_tube) file.add("PointData", "radius", radius_);
    file.add("PointData", "material", material_);
    file.add("PointData", "stitch", stitch_);
    file.add("CellData", "yarn", yarn_);
    return file.finish(points_.size() / 3, is_tube ? 0 : ends_.size(), is_tube ? ends_.size() : 0, "stretch_energy");
  }

 private:
  int next_point() const { return static_cast<int>(points_.size() / 3); }

  static void push(std::vector<float>& values, const Vec3& vector) {
    for (const double part : vector) values.push_back(static_cast<float>(part));
  }

  void add_point(const Vec3& position, const Station& at) {
    push(points_, position);
    radius_.push_back(static_cast<float>(at.radius));
    strain_.push_back(static_cast<float>(at.strain));
    stretch_energy_.push_back(static_cast<float>(at.stretch_energy));
    curvature_.push_back(static_cast<float>(at.curvature));
    material_.push_back(at.material);
    stitch_.push_back(at.stitch);
  }

  void add_ring(const Station& at, const Vec3& normal, const Vec3& binormal) {
    for (int side = 0; side < options_.sides; ++side) {
      const double angle = 2 * std::numbers::pi * side / options_.sides;
      const Vec3 out = std::cos(angle) * normal + std::sin(angle) * binormal;
      add_point(at.position + at.radius * out, at);
      push(normals_, out);
    }
  }

  void close_cell(int yarn) {
    ends_.push_back(static_cast<std::int32_t>(cells_.size()));
    yarn_.push_back(yarn);
  }

  const VtkOptions& options_;
  std::vector<float> points_, normals_, radius_, strain_, stretch_energy_, curvature_;
  std::vector<std::int32_t> material_, stitch_, yarn_, cells_, ends_;
};

std::string frame_name(std::size_t index) { return fmt::format("frames/frame_{:04}.vtp", index); }

}  // namespace

std::string vtp(const Fabric& fabric, const Points& q, const VtkOptions& options) {
  if (options.per_segment < 1 || options.sides < 3) throw std::invalid_argument("vtp: too few points or sides");
  const std::vector<double> strains = stretch_strains(fabric, q, options.rest);
  Surface surface(options);
  for (std::size_t i = 0; i < fabric.yarns.size(); ++i) {
    const std::vector<Station> yarn = stations(fabric, q, strains, fabric.yarns[i], options.per_segment);
    if (yarn.empty()) continue;
    if (options.shape == YarnShape::tubes)
      surface.add_tube(yarn, static_cast<int>(i));
    else
      surface.add_line(yarn, static_cast<int>(i));
  }
  return surface.finish();
}

void write_vtp(const Fabric& fabric, const Points& q, const std::string& path, const VtkOptions& options) {
  write_file(path, vtp(fabric, q, options));
}

void write_frames(const Results& results, const std::string& folder, const VtkOptions& options) {
  const std::filesystem::path root = folder;
  std::error_code error;
  std::filesystem::create_directories(root / "frames", error);
  if (error) throw std::system_error(error, "cannot write " + (root / "frames").string());
  std::string list = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
  double stage_start = 0, time = 0;
  std::size_t frames = 0;
  for (std::size_t i = 0; i < results.snapshots.size(); ++i) {
    const Snapshot& snapshot = results.snapshots[i];
    if (i > 0 && snapshot.stage != results.snapshots[i - 1].stage) stage_start = time;
    time = stage_start + snapshot.state.t;
    if (i > 0 && snapshot.sample == 0) continue;
    VtkOptions of_snapshot = options;
    of_snapshot.rest = rest_lengths_at(results.scene, snapshot);
    const Fabric shown = shown_fabric(results.scene.fabric, results.scene.gauge, snapshot.state.q);
    write_vtp(shown, shown.points, (root / frame_name(frames)).string(), of_snapshot);
    list += fmt::format("<DataSet timestep=\"{:.9g}\" part=\"0\" file=\"{}\"/>\n", time, frame_name(frames));
    ++frames;
  }
  write_file((root / "frames.pvd").string(), list + "</Collection>\n</VTKFile>\n");
}

}  // namespace wale
