#include "sim/stiffness.hpp"

#include <algorithm>

namespace wale {
namespace {

constexpr int few = 64;            // points for which threads cost more than they save
constexpr std::size_t spare = 32;  // the share, one in so many, for which room is made when values must move anyway

std::vector<Stiffness::Entry>::const_iterator find(const std::vector<Stiffness::Entry>& row, int column) {
  return std::lower_bound(row.begin(), row.end(), column,
                          [](const Stiffness::Entry& entry, int wanted) { return entry.column < wanted; });
}

}  // namespace

Stiffness::Stiffness(int points) : pattern_(std::make_shared<Pattern>()) {
  pattern_->rows.resize(static_cast<std::size_t>(points));
}

void Stiffness::clear() {
  fit();
  std::fill(values_.begin(), values_.end(), Mat3(Mat3::Zero()));
}

void Stiffness::fit() {
  const std::size_t slots = pattern_->slots;
  if (values_.size() == slots) return;
  if (values_.capacity() < slots) values_.reserve(values_.empty() ? slots : slots + slots / spare);
  values_.resize(slots, Mat3::Zero());
}

void Stiffness::scale(double factor) {
  for (Mat3& value : values_) value *= factor;
}

int Stiffness::slot(int i, int j) {
  assert(i <= j);
  fit();
  const auto& entries = row(i);
  const auto at = find(entries, j);
  if (at != entries.end() && at->column == j) return at->slot;
  const int made = static_cast<int>(pattern_->slots++);
  pattern_->enter(i, j, made);
  if (i != j) pattern_->enter(j, i, made);
  fit();
  return made;
}

void Stiffness::slots(int i, int j, int count, std::vector<int>& out) {
  out.resize(out.size() + static_cast<std::size_t>(count));
  make_slots(i, j, count, out.data() + out.size() - count);
}

void Stiffness::make_slots(int i, int j, int count, int* out) {
  const auto& entries = row(i);
  auto at = static_cast<std::size_t>(find(entries, j) - entries.begin());
  for (const int end = j + count; j < end; ++j, ++at, ++out) {
    if (at == entries.size() || entries[at].column != j) slot(i, j);
    *out = entries[at].slot;
  }
}

bool Stiffness::find_slots(int i, int j, int count, int* out) const {
  const auto& entries = row(i);
  auto at = find(entries, j);
  for (const int end = j + count; j < end; ++j, ++at, ++out) {
    if (at == entries.end() || at->column != j) return false;
    *out = at->slot;
  }
  return true;
}

void Stiffness::add(const Stiffness& other, double factor) {
  const std::vector<int>& slots = places(&other, static_cast<long>(other.slots()), [&](std::vector<int>& list) {
    for (int i = 0; i < other.points(); ++i)
      for (const Entry& entry : other.row(i))
        if (entry.column >= i) list.push_back(slot(i, entry.column));
  });
  std::size_t next = 0;
  for (int i = 0; i < other.points(); ++i)
    for (const Entry& entry : other.row(i))
      if (entry.column >= i) add_at(slots[next++], factor * other.at(entry.slot));
}

void Stiffness::add_part(const Stiffness& of, const std::vector<int>& points) {
  std::vector<int> place(static_cast<std::size_t>(of.points()), -1);
  for (int i = 0; i < static_cast<int>(points.size()); ++i)
    place[static_cast<std::size_t>(points[static_cast<std::size_t>(i)])] = i;
  for (const int point : points)
    for (const Entry& entry : of.row(point)) {
      const int column = place[static_cast<std::size_t>(entry.column)];
      if (entry.column >= point && column >= 0) add(place[static_cast<std::size_t>(point)], column, of.at(entry.slot));
    }
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

void Stiffness::Pattern::enter(int row, int column, int slot) {
  auto& entries = rows[static_cast<std::size_t>(row)];
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
