#include "sim/effects/bead_pushes.hpp"

#include <algorithm>

#include "sim/kernels/kernels.hpp"

namespace wale {
namespace {

/// What the contacts of a range of segments add to control points that other ranges add to as well.
struct Late {
  int first_point = 0;
  int image = 0;  // of Beads::images(): which of the segment was pushed
  Eigen::Matrix<double, 4, 3> force = Eigen::Matrix<double, 4, 3>::Zero();  // on four of them, N
};

class RangeOfSegments {
 public:
  RangeOfSegments(const Beads& beads, int first, int last)
      : beads_(beads),
        first_(first),
        last_(last),
        origin_(beads.fabric().first_point(first)),
        points_(beads.fabric().first_point(last - 1) + 4 - origin_) {}

  /// The energy of the range's contacts.
  double push(const ListContacts& list) {
    list(first_, last_, contacts_);
    if (contacts_.empty()) return 0;
    leaving_ = static_cast<std::size_t>(
        std::count_if(contacts_.begin(), contacts_.end(), [this](const auto& contact) { return leaves(contact); }));
    push_.resize(row() * static_cast<std::size_t>(last_ - first_));
    outgoing_.resize(row() * leaving_);
    return kernels().beads.push({.rows = beads_.rows(),
                                 .materials = beads_.fabric().materials.data(),
                                 .material = beads_.materials().data(),
                                 .images = beads_.image_rows().data(),
                                 .displacements = beads_.displacements().front().data(),
                                 .contacts = contacts_.data(),
                                 .count = static_cast<int>(contacts_.size()),
                                 .first = first_,
                                 .last = last_,
                                 .push = push_.data(),
                                 .outgoing = outgoing_.data()});
  }

  /// Adds to the range's control points, except the first three, which the range before has as well; what these get,
  /// and what leaves the range, is kept for later.
  void spread(Points& force, std::vector<Late>& late) const {
    if (contacts_.empty()) return;
    const auto stride = static_cast<long>(points_);
    std::vector<double> sum(3 * static_cast<std::size_t>(points_));
    std::vector<std::uint8_t> touched(static_cast<std::size_t>(last_ - first_));
    for (const BeadContact& contact : contacts_) {
      touched[static_cast<std::size_t>(contact.a - first_)] = 1;
      if (!leaves(contact)) touched[static_cast<std::size_t>(contact.b - first_)] = 1;
    }
    BeadSpreading spreading = beads_.spreading();
    spreading.touched = touched.data();
    spreading.push = push_.data();
    spreading.origin = origin_;
    spreading.force_stride = stride;
    spreading.force = sum.data();
    kernels().beads.spread(spreading, first_, last_);

    late.reserve(leaving_ + 1);
    Late& shared = late.emplace_back();
    shared.first_point = origin_;
    for (int c = 0; c < 3; ++c) std::copy_n(sum.data() + stride * c, shared_points, shared.force.col(c).data());
    for (long p = shared_points; p < stride; ++p)
      for (long c = 0; c < 3; ++c) force(c, origin_ + p) += sum[static_cast<std::size_t>(stride * c + p)];
    spread_outgoing(late);
  }

 private:
  static constexpr int shared_points = 3;

  std::size_t row() const { return 3 * static_cast<std::size_t>(beads_.rows().stride); }
  bool leaves(const BeadContact& contact) const { return contact.b >= last_ || contact.image > 0; }

  void spread_outgoing(std::vector<Late>& late) const {
    BeadSpreading spreading = beads_.spreading();
    constexpr std::uint8_t yes = 1;
    spreading.touched = &yes;
    spreading.push = outgoing_.data();
    spreading.force_stride = 4;
    for (const BeadContact& contact : contacts_) {
      if (!leaves(contact)) continue;
      Late& out = late.emplace_back();
      out.first_point = spreading.origin = beads_.fabric().first_point(contact.b);
      out.image = contact.image;
      spreading.force = out.force.data();
      kernels().beads.spread(spreading, contact.b, contact.b + 1);
      spreading.push += row();
    }
  }

  const Beads& beads_;
  int first_, last_, origin_, points_;
  std::size_t leaving_ = 0;
  std::vector<BeadContact> contacts_;
  std::vector<double> push_, outgoing_;  // rows of beads
};

void add_late(const Late& of, const Beads& beads, const Points& q, Points& force) {
  if (const Image* turned = beads.turned(of.image)) {
    const OnImage back = carried_back(*turned, q.middleCols<4>(of.first_point), of.force.transpose());
    force.middleCols<4>(of.first_point) += back.points;
    force.rightCols<2>() += back.periods;
    return;
  }
  // The three shared points of a yarn of one segment may be the last.
  const int points = std::min(4, static_cast<int>(force.cols()) - of.first_point);
  for (int k = 0; k < points; ++k) force.col(of.first_point + k) += of.force.row(k).transpose();
  // An image moves with the periods: together they bear what its control points do.
  if (of.image > 0)
    force.rightCols<2>() += of.force.colwise().sum().transpose() *
                            beads.images()[static_cast<std::size_t>(of.image)].cast<double>().transpose();
}

}  // namespace

void add_pushes(const Beads& beads, const Points& q, const ListContacts& list, Load& out) {
  const std::vector<int>& boundaries = beads.boundaries();
  std::vector<double> energies(boundaries.size() - 1);
  std::vector<std::vector<Late>> late(energies.size());
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < energies.size(); ++i) {
    RangeOfSegments range(beads, boundaries[i], boundaries[i + 1]);
    energies[i] = range.push(list);
    if (out.force) range.spread(*out.force, late[i]);
  }
  if (out.energy)
    for (const double energy : energies) *out.energy += energy;
  for (const std::vector<Late>& some : late)
    for (const Late& of : some) add_late(of, beads, q, *out.force);
}

}  // namespace wale
