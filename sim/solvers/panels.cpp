#include "sim/solvers/panels.hpp"

#include <algorithm>

namespace wale {
namespace {

/// (own; rest) := (L⁻¹ own; rest - M L⁻¹ own), of a vector by the rows of a panel, three columns at a time.
void eliminate(const float* values, int width, int height, double* x) {
  for (int j = 0; j < width; j += 3, values += 3 * height) {
    const float *a = values, *b = a + height, *c = b + height;
    const double first = x[j] * a[j], second = (x[j + 1] - a[j + 1] * first) * b[j + 1],
                 third = (x[j + 2] - a[j + 2] * first - b[j + 2] * second) * c[j + 2];
    x[j] = first, x[j + 1] = second, x[j + 2] = third;
#pragma omp simd
    for (int i = j + 3; i < height; ++i) x[i] -= a[i] * first + b[i] * second + c[i] * third;
  }
}

/// own := L⁻ᵀ (own - Mᵀ rest).
void substitute(const float* values, int width, int height, double* x) {
  values += 3 * (width / 3 - 1) * static_cast<std::ptrdiff_t>(height);
  for (int j = width - 3; j >= 0; j -= 3, values -= 3 * height) {
    const float *a = values, *b = a + height, *c = b + height;
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

Panels::Panels(const Supernodes& supernodes) {
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
  values_ = std::make_unique_for_overwrite<float[]>(values());
}

void Panels::keep(int supernode, const Eigen::Ref<const Eigen::MatrixXd>& columns) {
  const auto s = static_cast<std::size_t>(supernode);
  Eigen::Index done = 0;
  for (std::size_t p = first_[s]; p < first_[s + 1]; ++p) {
    const Eigen::Index width = 3 * panels_[p].width, height = 3 * panels_[p].height;
    Eigen::Map<Eigen::MatrixXf> values(values_.get() + starts_[p], height, width);
    values = columns.block(done, done, height, width).cast<float>();
    values.diagonal() = columns.diagonal().segment(done, width).cwiseInverse().cast<float>();
    done += width;
  }
}

void Panels::forward(Eigen::VectorXd& x) const {
  std::vector<double> mine(tallest_);
  for (std::size_t p = 0; p < panels_.size(); ++p) {
    const Panel& panel = panels_[p];
    auto own = x.segment(3 * panel.place, 3 * panel.width);
    Eigen::Map<Eigen::VectorXd> at(mine.data(), 3 * panel.height);
    at.head(3 * panel.width) = own;
    at.tail(3 * (panel.height - panel.width)).setZero();
    eliminate(values_of(p), 3 * panel.width, 3 * panel.height, mine.data());
    own = at.head(3 * panel.width);
    for (int r = panel.width; r < panel.height; ++r) x.segment<3>(3 * panel.rows[r]) += at.segment<3>(3 * r);
  }
}

void Panels::backward(Eigen::VectorXd& x) const {
  std::vector<double> mine(tallest_);
  for (std::size_t p = panels_.size(); p-- > 0;) {
    const Panel& panel = panels_[p];
    Eigen::Map<Eigen::VectorXd> at(mine.data(), 3 * panel.height);
    for (int r = 0; r < panel.height; ++r) at.segment<3>(3 * r) = x.segment<3>(3 * panel.rows[r]);
    substitute(values_of(p), 3 * panel.width, 3 * panel.height, mine.data());
    x.segment(3 * panel.place, 3 * panel.width) = at.head(3 * panel.width);
  }
}

}  // namespace wale
