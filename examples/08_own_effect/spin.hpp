/// The centrifugal force on yarn that is seen from a frame which turns with it, as in a spin dryer:
/// V = -½ ω² ρ l0 ∫ r² ds, with the distance r of the yarn from the axis of the turning.
#pragma once

#include "sim/effect.hpp"
#include "sim/spline.hpp"

class Spin final : public wale::Effect {
 public:
  /// About an axis through the origin, of length 1; `speed` is ω, rad/s. `fabric` must outlive the effect.
  Spin(const wale::Fabric& fabric, double speed, const wale::Vec3& axis)
      : fabric_(fabric), speed_(speed), across_(wale::Mat3::Identity() - axis * axis.transpose()) {
    for (const wale::GaussNode& node : wale::gauss(4)) {  // exact: b_j b_k is of degree 6
      const wale::Basis at = wale::basis(node.s);
      const Eigen::Map<const Eigen::Vector4d> b(at.value.data());
      shares_ += node.weight * b * b.transpose();
    }
  }

  std::string_view name() const override { return "spin"; }

  void add(const wale::State& at, wale::Load& out) const override {
    if (!out.energy && !out.force && !out.stiffness) return;
    for (int i = 0; i < fabric_.segment_count(); ++i) {
      const double strength = speed_ * speed_ * fabric_.material_of(i).linear_density * fabric_.segment(i).length;
      const int first = fabric_.first_point(i);
      const Eigen::Matrix<double, 3, 4> outwards = across_ * at.q.middleCols<4>(first);
      const Eigen::Matrix<double, 3, 4> force = strength * outwards * shares_;
      if (out.energy) *out.energy -= force.cwiseProduct(outwards).sum() / 2;
      if (out.force) out.force->middleCols<4>(first) += force;
      if (out.stiffness)
        for (int j = 0; j < 4; ++j)
          for (int k = j; k < 4; ++k) out.stiffness->add(first + j, first + k, -strength * shares_(j, k) * across_);
      // `convex` gets nothing: a yarn further out is pulled more, so that all of this stiffness is negative.
    }
  }

 private:
  const wale::Fabric& fabric_;
  double speed_;
  wale::Mat3 across_;                                 // takes out what lies along the axis
  Eigen::Matrix4d shares_ = Eigen::Matrix4d::Zero();  // ∫ b_j b_k ds over a segment
};
