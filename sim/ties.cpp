#include "sim/ties.hpp"

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
    }
    free_ += yarn.segments;
  }
  for (int period = 0; period < 2; ++period) {
    first_.push_back(free_++);
    follows_.push_back(false);
  }
}

std::array<int, 2> Ties::parts(int column) const { return {free_column(column), follows(column) ? free_ - 2 : -1}; }

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
    if (follows(i)) all.col(i) += free.col(free_ - 2);
  }
  return all;
}

Points Ties::gather(const Points& all) const {
  if (empty()) return all;
  Points free = Points::Zero(3, free_);
  for (int i = 0; i < columns_; ++i)
    for (const int part : parts(i))
      if (part >= 0) free.col(part) += all.col(i);
  return free;
}

void Ties::gather(const Stiffness& by_all, Stiffness& by_free) const {
  by_free.clear();
  for (int i = 0; i < columns_; ++i)
    for (const Stiffness::Entry& entry : by_all.row(i)) {
      const int j = entry.column;
      if (j < i) continue;
      const Mat3& block = by_all.at(entry.slot);
      for (const int p : parts(i))
        for (const int q : parts(j)) {
          if (p < 0 || q < 0 || (i == j && p > q)) continue;
          if (p == q && i != j)
            by_free.add(p, p, block + block.transpose());
          else if (p <= q)
            by_free.add(p, q, block);
          else
            by_free.add(q, p, block.transpose());
        }
    }
}

}  // namespace wale
