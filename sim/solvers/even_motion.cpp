#include "sim/solvers/even_motion.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/cubes.hpp"

namespace wale {
namespace {

constexpr double harmless = 0.5;        // strain and turn, which bring nothing to the other side of anything
constexpr std::size_t least_cubes = 4;  // in all of a fabric, for its patches to be worth a look

using Vec4 = Eigen::Vector4d;
using Affine = Eigen::Matrix<double, 3, 4>;  // of a place with a one below

/// Sums over control points: of their places, a one below each, with themselves and with the motions.
struct Moments {
  Eigen::Matrix4d places = Eigen::Matrix4d::Zero();
  Eigen::Matrix<double, 4, 3> motions = Eigen::Matrix<double, 4, 3>::Zero();

  void add(const Vec4& place, const Vec3& motion) {
    places += place * place.transpose();
    motions += place * motion.transpose();
  }
  void add(const Moments& other) {
    places += other.places;
    motions += other.motions;
  }

  /// The even motion, of places that are measured in `unit`.
  Affine even(double unit) const {
    Affine even = Affine::Zero();
    if (places(3, 3) == 0) return even;
    // A flat or straight fabric says nothing of some directions: the least change there is none.
    even = places.completeOrthogonalDecomposition().solve(motions).transpose();
    if (even.leftCols<3>().norm() < harmless * unit) return even;
    even.setZero();
    even.col(3) = motions.row(3).transpose() / places(3, 3);
    return even;
  }
};

/// The eight cubes around each corner of cubes: any two points no further apart than a cube is wide lie in one patch.
class Patches {
 public:
  /// There are no more cubes than points.
  Patches(const Points& q, double width)
      : cubes_(q, width, static_cast<double>(q.cols())), count_(cubes_.count() + 1) {}

  std::size_t cubes() const { return cubes_.all(); }

  /// The largest motion beyond the even one of any patch that a point lies in.
  double uneven(const Points& q, const Points& move) const {
    const auto even = even_motions(q, move);
    double most = 0;
#pragma omp parallel for schedule(static) reduction(max : most)
    for (Eigen::Index k = 0; k < q.cols(); ++k) {
      const Vec4 at = place(q.col(k));
      each_patch(cubes_.of(q.col(k)),
                 [&](std::size_t patch) { most = std::max(most, (move.col(k) - even[patch] * at).squaredNorm()); });
    }
    return std::sqrt(most);
  }

 private:
  Vec4 place(const Vec3& at) const { return cubes_.in_widths(at).homogeneous(); }

  template <class Visit>
  void each_patch(const CubeIndex& cube, const Visit& visit) const {
    for (int corner = 0; corner < 8; ++corner)
      visit(Cubes::flat_in(count_, cube + CubeIndex(corner & 1, corner >> 1 & 1, corner >> 2)));
  }

  std::vector<Affine> even_motions(const Points& q, const Points& move) const {
    std::vector<Moments> of_cube(cubes_.all()), of_patch(Cubes::flat_in(count_, count_ - 1) + 1);
    for (Eigen::Index k = 0; k < q.cols(); ++k)
      of_cube[cubes_.flat(cubes_.of(q.col(k)))].add(place(q.col(k)), move.col(k));
    const CubeIndex& count = cubes_.count();
    for (CubeIndex at(0, 0, 0); at.z() < count.z(); ++at.z())
      for (at.y() = 0; at.y() < count.y(); ++at.y())
        for (at.x() = 0; at.x() < count.x(); ++at.x())
          each_patch(at, [&](std::size_t patch) { of_patch[patch].add(of_cube[cubes_.flat(at)]); });
    std::vector<Affine> even;
    for (const Moments& moments : of_patch) even.push_back(moments.even(cubes_.width()));
    return even;
  }

  Cubes cubes_;
  CubeIndex count_;  // of patches along each axis
};

/// No point of a yarn is further from a control point that bends it, m.
double longest_support(const Fabric& fabric, const Points& q) {
  double longest = 0;
  for (const Yarn& yarn : fabric.yarns)
    for (int k = yarn.first_point; k + 1 < yarn.first_point + yarn.points(); ++k)
      longest = std::max(longest, (q.col(k + 1) - q.col(k)).squaredNorm());
  return 3 * std::sqrt(longest);
}

}  // namespace

double largest_motion(const Points& from, const Points& to) { return (to - from).colwise().norm().maxCoeff(); }

Points even_motion(const Points& q, const Points& move) {
  const Vec3 middle = q.rowwise().mean();
  Moments moments;
  for (Eigen::Index k = 0; k < q.cols(); ++k) moments.add((q.col(k) - middle).homogeneous(), move.col(k));
  return moments.even(1) * (q.colwise() - middle).colwise().homogeneous();
}

double uneven_motion(const Points& q, const Points& move) { return largest_motion(even_motion(q, move), move); }

double uneven_motion_nearby(const Fabric& fabric, const Points& q, const Points& move) {
  const double of_all = uneven_motion(q, move);
  if (fabric.cell || !std::isfinite(of_all)) return of_all;
  const Patches patches(q, 2 * (of_all + longest_support(fabric, q)));
  return patches.cubes() < least_cubes ? of_all : std::min(of_all, patches.uneven(q, move));
}

}  // namespace wale
