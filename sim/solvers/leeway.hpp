/// How far neighbouring pieces of yarn may move against each other in one step of an iteration.
#pragma once

#include <array>
#include <vector>

#include "sim/effect.hpp"

namespace wale {

/// Neighbours are control points that follow each other along a yarn, and segments of which the contact list says that
/// they are near. Motion that they share costs nothing: a swatch of any size may be stretched, moved or turned in as
/// many iterations as a small one.
class Leeway {
 public:
  explicit Leeway(const Fabric&);

  /// Takes the neighbours that are near now.
  void update(const Points& q, const std::vector<Gap>& gaps);
  /// The largest motion of neighbours against each other, over what they are allowed: 0.3 d along a yarn; of two
  /// segments 0.9 of their gap, so that they do not meet, between 0.1 and 0.6 d. `move` has the columns of
  /// State::q.
  double share(const Points& move) const;
  /// Adds weight/2 Σ |Δ_i - Δ_j|² over neighbours that touch, where the weight is the mean of those of the control
  /// points, N/m; and a little of it for motion that all share: a hundredth where nothing touches, elsewhere no more
  /// than lets all of a large fabric stretch and move as easily as a small one. `weights` has the columns of State::q.
  void add_to(Stiffness& K, const Eigen::VectorXd& weights) const;

 private:
  struct Near {
    int a = 0, b = 0;  // first control points
    Eigen::Vector2i image;
    double allowed = 0;  // m
    bool touches = false;
    int turned = -1;  // of turned_, if b is an image that turns
  };
  /// How an image that turns moves with the mean of its control points and with the periods.
  struct Turned {
    Mat3 turn;
    std::array<Mat3, 2> by_period;
  };
  void share_motion(const Points& q);
  Vec3 apart(const Near&, const Points& move) const;
  double mean(const Near&, const Eigen::VectorXd& weights) const;
  /// Calls add(i, j, factor) for every block between neighbours that add_to() adds to, i <= j.
  template <class Add>
  void each_block(const Eigen::VectorXd& weights, const Add& add) const;
  /// The same with images that turn, and with the blocks.
  template <class Add>
  void each_turned_block(const Eigen::VectorXd& weights, const Add& add) const;

  const Fabric& fabric_;
  double thickness_ = 0;  // of the thinnest yarn, m
  std::vector<Near> near_;
  std::vector<Turned> turned_;
  Eigen::VectorXd shared_;  // of the weight, for motion that all share, by column of State::q
  long version_ = 0;        // of near_
};

}  // namespace wale
