#include "sim/solvers/panels.hpp"

#include <algorithm>

namespace wale {
namespace {

/// (own; rest) := (L⁻¹ own; rest - M L⁻¹ own), of a vector by the rows of a panel, three columns at a time.
template <class Value>
void eliminate(const Value* values, int width, int height, double* x) {
  for (int j = 0; j < width; j += 3, values += 3 * height) {
    const Value *a = values, *b = a + height, *c = b + height;
    const double first = x[j] * a[j], second = (x[j + 1] - a[j + 1] * first) * b[j + 1],
                 third = (x[j + 2] - a[j + 2] * first - b[j + 2] * second) * c[j + 2];
    x[j] = first, x[j + 1] = second, x[j + 2] = third;
#pragma omp simd
    for (int i = j + 3; i < height; ++i) x[i] -= a[i] * first + b[i] * second + c[i] * third;
  }
}

/// own := L⁻ᵀ (own - Mᵀ rest).
template <class Value>
void substitute(const Value* values, int width, int height, double* x) {
  for (int j = width - 3; j >= 0; j -= 3) {
    const Value *a = values + j * static_cast<std::ptrdiff_t>(height), *b = a + height, *c = b + height;
    double first = 0, second = 0, third = 0;
#pragma omp simd reduction(+ : first, second, third)
    for (int i = j + 3; i < height; ++i) {
      first += a[i] * x[i];
      second += b[i] * x[i];
      third += c[i] * x[i];
    }
    x[j + 2] = (x[j + 2] - third) * c[j + 2];
    x[j + 1] = (x[j + 1] - second - b[j + 2] * x[j + 2]) * b[j + 1];
    x[j] = (x[j] - first - a[j + 1] * x[j + 1] - a[j + 2] * x[j + 2]) * a[j];
  }
}

}  // namespace

Panels::Panels(const Supernodes& supernodes, Precision precision) {
  for (int s = 0; s < supernodes.count(); ++s) {
    first_.push_back(panels_.size());
    for (int done = 0; done < supernodes.width(s); done += widest) {
      const Panel& panel = panels_.emplace_back(Panel{.place = supernodes.first(s) + done,
                                                      .width = std::min(widest, supernodes.width(s) - done),
                                                      .height = supernodes.height(s) - done,
                                                      .rows = supernodes.rows(s) + done});
      const auto columns = 3 * static_cast<std::size_t>(panel.width), rows = 3 * static_cast<std::size_t>(panel.height);
      starts_.push_back(starts_.back() + columns * rows);
      tallest_ = std::max(tallest_, rows);
    }
  }
  first_.push_back(panels_.size());
  if (precision == Precision::single_)
    values_.emplace<LargeArray<float>>(values());
  else
    values_.emplace<LargeArray<double>>(values());
}

template <class Value>
void Panels::keep(int supernode, const Eigen::Ref<const Eigen::MatrixXd>& columns, Value* values) const {
  const auto s = static_cast<std::size_t>(supernode);
  Eigen::Index done = 0;
  for (std::size_t p = first_[s]; p < first_[s + 1]; ++p) {
    const Eigen::Index width = 3 * panels_[p].width, height = 3 * panels_[p].height;
    Eigen::Map<Eigen::Matrix<Value, Eigen::Dynamic, Eigen::Dynamic>> kept(values + starts_[p], height, width);
    kept = columns.block(done, done, height, width).template cast<Value>();
    kept.diagonal() = columns.diagonal().segment(done, width).cwiseInverse().template cast<Value>();
    done += width;
  }
}

template <class Value>
void Panels::forward(const Value* values, Eigen::VectorXd& x) const {
  std::vector<double> mine(tallest_);
  for (std::size_t p = 0; p < panels_.size(); ++p) {
    const Panel& panel = panels_[p];
    auto own = x.segment(3 * panel.place, 3 * panel.width);
    Eigen::Map<Eigen::VectorXd> at(mine.data(), 3 * panel.height);
    at.head(3 * panel.width) = own;
    at.tail(3 * (panel.height - panel.width)).setZero();
    eliminate(values + starts_[p], 3 * panel.width, 3 * panel.height, mine.data());
    own = at.head(3 * panel.width);
    for (int r = panel.width; r < panel.height; ++r) x.segment<3>(3 * panel.rows[r]) += at.segment<3>(3 * r);
  }
}

template <class Value>
void Panels::backward(const Value* values, Eigen::VectorXd& x) const {
  std::vector<double> mine(tallest_);
  for (std::size_t p = panels_.size(); p-- > 0;) {
    const Panel& panel = panels_[p];
    Eigen::Map<Eigen::VectorXd> at(mine.data(), 3 * panel.height);
    for (int r = 0; r < panel.height; ++r) at.segment<3>(3 * r) = x.segment<3>(3 * panel.rows[r]);
    substitute(values + starts_[p], 3 * panel.width, 3 * panel.height, mine.data());
    x.segment(3 * panel.place, 3 * panel.width) = at.head(3 * panel.width);
  }
}

void Panels::keep(int supernode, const Eigen::Ref<const Eigen::MatrixXd>& columns) {
  std::visit([&](auto& values) { keep(supernode, columns, values.data()); }, values_);
}

void Panels::forward(Eigen::VectorXd& x) const {
  std::visit([&](const auto& values) { forward(values.data(), x); }, values_);
}

void Panels::backward(Eigen::VectorXd& x) const {
  std::visit([&](const auto& values) { backward(values.data(), x); }, values_);
}

}  // namespace wale
