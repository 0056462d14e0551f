#include "sim/stiffness.hpp"

#include <algorithm>

namespace wale {
namespace {

constexpr int few = 64;  // points for which threads cost more than they save

std::vector<Stiffness::Entry>::const_iterator find(const std::vector<Stiffness::Entry>& row, int column) {
  return std::lower_bound(row.begin(), row.end(), column,
                          [](const Stiffness::Entry& entry, int wanted) { return entry.column < wanted; });
}

}  // namespace

Stiffness::Stiffness(int points) : rows_(static_cast<std::size_t>(points)) {}

void Stiffness::clear() { std::fill(values_.begin(), values_.end(), Mat3(Mat3::Zero())); }

int Stiffness::slot(int i, int j) {
  assert(i <= j);
  const auto& row = rows_[static_cast<std::size_t>(i)];
  const auto at = find(row, j);
  if (at != row.end() && at->column == j) return at->slot;
  const int made = static_cast<int>(values_.size());
  enter(i, j, made);
  if (i != j) enter(j, i, made);
  values_.emplace_back(Mat3::Zero());
  ++version_;
  return made;
}

void Stiffness::slots(int i, int j, int count, std::vector<int>& out) {
  const auto& row = rows_[static_cast<std::size_t>(i)];
  auto at = static_cast<std::size_t>(find(row, j) - row.begin());
  for (const int end = j + count; j < end; ++j, ++at) {
    if (at == row.size() || row[at].column != j) slot(i, j);
    out.push_back(row[at].slot);
  }
}

void Stiffness::add(const Stiffness& other, double factor) {
  const std::vector<int>& slots = places(&other, other.version(), [&](std::vector<int>& list) {
    for (int i = 0; i < other.points(); ++i)
      for (const Entry& entry : other.row(i))
        if (entry.column >= i) list.push_back(slot(i, entry.column));
  });
  std::size_t next = 0;
  for (int i = 0; i < other.points(); ++i)
    for (const Entry& entry : other.row(i))
      if (entry.column >= i) add_at(slots[next++], factor * other.at(entry.slot));
}

void Stiffness::hold(int point, int axis, double diagonal) {
  for (const Entry& entry : row(point)) {
    Mat3& block = values_[static_cast<std::size_t>(entry.slot)];
    if (entry.column < point)
      block.col(axis).setZero();
    else
      block.row(axis).setZero();
    if (entry.column == point) block.col(axis).setZero();
  }
  values_[static_cast<std::size_t>(slot(point, point))](axis, axis) = diagonal;
}

void Stiffness::enter(int row, int column, int slot) {
  auto& entries = rows_[static_cast<std::size_t>(row)];
  entries.insert(find(entries, column), {column, slot});
}

void Stiffness::multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const {
  y.resize(x.size());
#pragma omp parallel for schedule(static) if (points() > few)
  for (int i = 0; i < points(); ++i) {
    Vec3 sum = Vec3::Zero();
    for (const Entry& entry : row(i)) {
      const auto of = x.segment<3>(3 * entry.column);
      if (entry.column < i)
        sum += at(entry.slot).transpose() * of;
      else
        sum += at(entry.slot) * of;
    }
    y.segment<3>(3 * i) = sum;
  }
}

}  // namespace wale
