/// The yarns that the simulator moves: materials, segments, control points. SI units throughout.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cassert>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wale {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Points = Eigen::Matrix3Xd;  ///< one column per control point, m

enum class ContactLaw : std::uint8_t {
  barrier,    ///< k (1/δ² + δ² - 2), infinite at δ = 0 (Kaldor et al. 2008); the default
  quadratic,  ///< k (δ - 1)², finite at δ = 0: yarns can pull through (Ding et al. 2023, Eq. 18)
  core_shell  ///< k ((1 - δ)/(δ - c))^p, infinite where the cores touch (after Singal et al. 2024)
};

/// As users and files spell them, in the order of ContactLaw.
inline constexpr std::array<std::string_view, 3> contact_law_names{"barrier", "quadratic", "core_shell"};

/// A yarn as the mechanics sees it. The defaults are the corrected 16/2 acrylic of Ding et al. 2023, Table 1.
struct Material {
  std::string name = "acrylic_16_2";
  double linear_density = 77e-6;       ///< rho, kg/m
  double axial_stiffness = 68.1;       ///< EA, N
  double bending_rigidity = 1.474e-8;  ///< EI, N m²
  double diameter = 0.524e-3;          ///< contact diameter d, m
  ContactLaw law = ContactLaw::barrier;
  double contact_stiffness = 300;  ///< k, N/m
  double core_diameter = 0.2e-3;   ///< core_shell only: c = core_diameter / diameter, m
  double shell_exponent = 2.4;     ///< core_shell only: p > 2
  bool operator==(const Material&) const = default;
};

/// One unit of the spline parameter. The yarn's rest length goes from `length` to `knitted` while a fabric is
/// tightened.
struct Segment {
  std::int32_t yarn = 0;      ///< index into Fabric::yarns
  std::int32_t material = 0;  ///< index into Fabric::materials
  std::int32_t stitch = -1;   ///< index into StitchGraph::loops, of a periodic fabric those of the
                              ///< larger piece that it is cut from; -1 for cast-on, bind-off and joins
  double length = 0;          ///< rest length as laid by the compiler (l0), m; sets the mass
  double knitted = 0;         ///< rest length that the stitch length asks for (η l0), m
  std::int32_t line = 0;      ///< of Fabric::source, where the stitch is asked for, from 1; 0 if nobody knows
  std::int32_t column = 0;    ///< likewise, in bytes
};

/// A yarn of n segments has n + 3 control points, q_-1 ... q_n+1, in adjacent columns.
struct Yarn {
  int first_point = 0;
  int first_segment = 0;
  int segments = 0;
  int points() const { return segments + 3; }
};

/// Whether a periodic fabric may curl: then it goes on around an axis beside it, as a cylinder, and is flat only as
/// long as its curvature is 0. See Image.
enum class Curls : std::uint8_t {
  never,
  about_courses,  ///< the axis lies along x: each course is straight, and the wales are bent
  about_wales     ///< the axis lies along y: each wale is straight, and the courses are bent
};

/// One repeat of a fabric without end: everything in it comes again after each period. Every yarn goes on by the course
/// period, so that its last three control points are its first three, one course period on (around the axis, if the
/// fabric curls about its wales). tile() lays several repeats side by side; Scene::crossings of such a fabric are
/// segments of a tile.
struct PeriodicCell {
  Vec3 course = Vec3::Zero();  ///< from a stitch to the same one a repeat to its right, m
  Vec3 wale = Vec3::Zero();    ///< from a stitch to the same one a repeat above, m
  Curls curls = Curls::never;
  bool may_curl() const { return curls != Curls::never; }
};

struct Fabric {
  std::string source;  ///< name of the text that asks for the stitches, as a user would type it; may be empty
  std::vector<Material> materials;
  std::vector<Yarn> yarns;
  std::vector<Segment> segments;     ///< all yarns, in order
  Points points;                     ///< 3 x M, as laid by the compiler
  std::optional<PeriodicCell> cell;  ///< of a periodic fabric, as laid by the compiler

  /// The first of the four control points (adjacent columns) that carry a segment.
  int first_point(int segment) const {
    const Yarn& yarn = yarns[static_cast<std::size_t>(segments[static_cast<std::size_t>(segment)].yarn)];
    return yarn.first_point + segment - yarn.first_segment;
  }
  int segment_count() const { return static_cast<int>(segments.size()); }
  const Segment& segment(int i) const { return segments[static_cast<std::size_t>(i)]; }
  const Material& material_of(int i) const { return materials[static_cast<std::size_t>(segment(i).material)]; }
};

}  // namespace wale
