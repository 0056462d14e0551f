#include "sim/solvers/cholesky.hpp"

#include <algorithm>
#include <optional>

#include "sim/lapack.hpp"
#include "sim/solvers/dissection.hpp"
#include "sim/solvers/part_factor.hpp"

namespace wale {
namespace {

// A product takes so much longer in a solve, which waits for memory, than in a factor; measured.
constexpr double waiting_for_memory = 12;
constexpr double much_fuller = 1.05;  // than the factor for which the order was made

/// Calls act(p) for every part, each on a thread of its own if there are as many. False if any is. Throws
/// std::bad_alloc.
template <class Act>
bool each(std::size_t parts, const Act& act) {
  bool good = true, enough_memory = true;
#pragma omp parallel for schedule(static, 1) if (parts > 1) reduction(&& : good, enough_memory)
  for (std::size_t p = 0; p < parts; ++p) {
    try {
      good = act(p) && good;
    } catch (const std::bad_alloc&) {
      enough_memory = false;
    }
  }
  if (!enough_memory) throw std::bad_alloc();
  return good;
}

}  // namespace

struct Cholesky::Work {
  UsedBlocks used;
  std::optional<Dissection> dissection;
  std::size_t values_then = 0;  // in the factor, when the dissection was made
  std::vector<std::unique_ptr<PartFactor>> parts;
  std::vector<LowerTriangle> left;  // what the border loses to each, until they are summed
  Eigen::MatrixXd border;           // the lower triangle of the factor of what they leave; dense
  bool is_factored = false;

  Eigen::Index border_size() const { return 3 * static_cast<Eigen::Index>(dissection->border.size()); }
  void follow_pattern(const Stiffness& K);
  std::size_t make_parts(const Stiffness& K);
  bool factor_border(const Stiffness& K, double shift);
};

Cholesky::Cholesky() : work_(std::make_unique<Work>()) {}
Cholesky::~Cholesky() = default;

void Cholesky::forget() { work_ = std::make_unique<Work>(); }

/// A few new blocks may fill a factor in an old order to several times its size.
void Cholesky::Work::follow_pattern(const Stiffness& K) {
  if (!used.update(K)) return;
  const bool may_stay = dissection && separates(*dissection, K, used);
  if (may_stay && static_cast<double>(make_parts(K)) < much_fuller * static_cast<double>(values_then)) return;
  dissection = dissect(K, used);
  values_then = make_parts(K);
}

/// Answers how many values the factors have.
std::size_t Cholesky::Work::make_parts(const Stiffness& K) {
  parts.clear();
  // The implicit solver takes what a solve answers as it is, and small matrices lack no memory.
  const Precision precision = K.points() < many_points ? Precision::double_ : Precision::single_;
  parts.resize(dissection->parts.size());
  each(parts.size(), [&](std::size_t p) {
    parts[p] = std::make_unique<PartFactor>(K, used, dissection->parts[p], dissection->border, precision);
    return true;
  });
  std::size_t values = 0;
  for (const auto& part : parts) values += part->values();
  return values;
}

bool Cholesky::Work::factor_border(const Stiffness& K, double shift) {
  const std::vector<int>& points = dissection->border;
  if (points.empty()) return true;
  std::vector<int> place(static_cast<std::size_t>(K.points()), -1);
  for (std::size_t k = 0; k < points.size(); ++k) place[static_cast<std::size_t>(points[k])] = static_cast<int>(k);
  border.setZero(border_size(), border_size());
  for (const LowerTriangle& of_part : left) of_part.add_to(border);
  left.clear();
  for (const int i : points)
    for (const Stiffness::Entry& entry : K.row(i)) {
      const int row = place[static_cast<std::size_t>(i)], column = place[static_cast<std::size_t>(entry.column)];
      if (column < 0 || column > row) continue;
      const Mat3& block = K.at(entry.slot);
      border.block<3, 3>(3 * row, 3 * column) += entry.column < i ? Mat3(block.transpose()) : block;
    }
  border.diagonal().array() += shift;
  return lapack::dpotrf(border) == 0;
}

bool Cholesky::factor(const Stiffness& K, double shift) {
  Work& work = *work_;
  work.is_factored = false;
  try {
    work.follow_pattern(K);
  } catch (const std::bad_alloc&) {
    forget();  // what is half made
    throw;
  }
  work.border.resize(0, 0);
  work.left.assign(work.parts.size(), LowerTriangle(0));
  work.is_factored = each(work.parts.size(), [&](std::size_t p) {
    work.left[p] = LowerTriangle(work.border_size());
    return work.parts[p]->factor(K, shift, work.used, work.left[p]);
  });
  work.is_factored = work.is_factored && work.factor_border(K, shift);
  return work.is_factored;
}

int Cholesky::solves_a_factor() const {
  if (!work_->is_factored) return -1;
  double factor = 0, solve = 0;  // products and sums
  for (const auto& part : work_->parts) {
    factor += part->factor_work();
    solve += 4 * static_cast<double>(part->values());
  }
  return static_cast<int>(factor / (waiting_for_memory * solve));
}

void Cholesky::solve(Eigen::VectorXd& x) const {
  Work& work = *work_;
  const std::vector<int>& points = work.dissection->border;
  std::vector<Eigen::VectorXd> by_part(work.parts.size(), Eigen::VectorXd::Zero(work.border_size()));
  each(work.parts.size(), [&](std::size_t p) {
    work.parts[p]->forward(x, by_part[p]);
    return true;
  });
  Eigen::VectorXd at_border(work.border_size());
  for (std::size_t k = 0; k < points.size(); ++k)
    at_border.segment<3>(3 * static_cast<Eigen::Index>(k)) = x.segment<3>(3 * points[k]);
  for (const Eigen::VectorXd& of_part : by_part) at_border += of_part;
  if (!points.empty()) {
    work.border.triangularView<Eigen::Lower>().solveInPlace(at_border);
    work.border.transpose().triangularView<Eigen::Upper>().solveInPlace(at_border);
  }
  each(work.parts.size(), [&](std::size_t p) {
    work.parts[p]->backward(at_border, x);
    return true;
  });
  for (std::size_t k = 0; k < points.size(); ++k)
    x.segment<3>(3 * points[k]) = at_border.segment<3>(3 * static_cast<Eigen::Index>(k));
}

}  // namespace wale
