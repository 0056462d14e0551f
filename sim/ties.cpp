#include "sim/ties.hpp"

#include "sim/tile.hpp"

namespace wale {

Ties::Ties(const Fabric& fabric) : columns_(static_cast<int>(fabric.points.cols())), free_(columns_) {
  if (!fabric.cell) return;
  columns_ += 2;
  free_ = 0;
  for (const Yarn& yarn : fabric.yarns) {
    for (int k = 0; k < yarn.points(); ++k) {
      const bool follows = k >= yarn.segments;
      first_.push_back(follows ? free_ + k - yarn.segments : free_ + k);
      follows_.push_back(follows);
      leader_.push_back(yarn.first_point + (follows ? k - yarn.segments : k));
    }
    free_ += yarn.segments;
  }
  for (int period = 0; period < 2; ++period) {
    first_.push_back(free_++);
    follows_.push_back(false);
    leader_.push_back(columns_ - 2 + period);
  }
  if (fabric.cell->curls != Curls::about_wales) return;
  cell_ = fabric.cell;
  look_at(points_and_periods(fabric));
}

void Ties::look_at(const Points& q) {
  if (!turn()) return;
  seen_ = q;
  on_.emplace(*cell_, q.rightCols<2>(), Eigen::Vector2i(1, 0));
}

void Ties::follow(Points& q) const {
  if (!turn()) return;
  const Image on(*cell_, q.rightCols<2>(), {1, 0});
  for (int i = 0; i < columns_; ++i)
    if (follows(i)) q.col(i) = on(q.col(leader(i)));
}

std::array<Ties::Part, 3> Ties::parts(int column) const {
  std::array<Part, 3> all;
  all[0].free = free_column(column);
  if (!follows(column)) return all;
  all[1].free = free_ - 2;
  if (!turn()) return all;
  const Vec3 leads = seen_.col(leader(column));
  all[0].by = on_->turn();
  all[1].by = on_->by_period(leads, 0);
  all[2] = {free_ - 1, on_->by_period(leads, 1)};
  return all;
}

Points Ties::pick(const Points& all) const {
  if (empty()) return all;
  Points free(3, free_);
  for (int i = 0; i < columns_; ++i)
    if (!follows(i)) free.col(free_column(i)) = all.col(i);
  return free;
}

Points Ties::spread(const Points& free) const {
  if (empty()) return free;
  Points all(3, columns_);
  for (int i = 0; i < columns_; ++i) {
    all.col(i) = free.col(free_column(i));
    if (!follows(i)) continue;
    if (!turn()) {
      all.col(i) += free.col(free_ - 2);
      continue;
    }
    all.col(i).setZero();
    for (const Part& part : parts(i)) all.col(i) += part.by * free.col(part.free);
  }
  return all;
}

Points Ties::gather(const Points& all) const {
  if (empty()) return all;
  Points free = Points::Zero(3, free_);
  for (int i = 0; i < columns_; ++i)
    for (const Part& part : parts(i)) {
      if (part.free < 0) break;
      if (turn())
        free.col(part.free) += part.by.transpose() * all.col(i);
      else
        free.col(part.free) += all.col(i);
    }
  return free;
}

void Ties::gather(const Stiffness& by_all, Stiffness& by_free) const {
  by_free.clear();
  for (int i = 0; i < columns_; ++i)
    for (const Stiffness::Entry& entry : by_all.row(i)) {
      const int j = entry.column;
      if (j < i) continue;
      const Mat3& block = by_all.at(entry.slot);
      for (const Part& p : parts(i))
        for (const Part& q : parts(j)) {
          if (p.free < 0 || q.free < 0 || (i == j && p.free > q.free)) continue;
          const Mat3 moved = turn() ? Mat3(p.by.transpose() * block * q.by) : block;
          if (p.free == q.free && i != j)
            by_free.add(p.free, p.free, moved + moved.transpose());
          else if (p.free <= q.free)
            by_free.add(p.free, q.free, moved);
          else
            by_free.add(q.free, p.free, moved.transpose());
        }
    }
}

void Ties::add_turning(const Points& force, Stiffness& by_free) const {
  if (!turn()) return;
  for (int i = 0; i < columns_; ++i) {
    if (!follows(i)) continue;
    const Vec3 leads = seen_.col(leader(i)), on_it = force.col(i);
    for (int period = 0; period < 2; ++period) {
      by_free.add(free_column(i), free_ - 2 + period, -on_->mixed(on_it, period));
      for (int other = period; other < 2; ++other)
        by_free.add(free_ - 2 + period, free_ - 2 + other, -on_->by_periods(on_it, leads, period, other));
    }
  }
}

}  // namespace wale
