#include "sim/solvers/front_sequence.hpp"

#include <algorithm>

#include "sim/solvers/lower_triangle.hpp"

namespace wale {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

std::size_t values_of_columns(const Supernodes& all, int s) { return 9 * index(all.width(s)) * index(all.height(s)); }

std::size_t values_left(const Supernodes& all, int s) {
  if (all.parent(s) < 0) return 0;
  return static_cast<std::size_t>(LowerTriangle::values(Eigen::Index{3} * (all.height(s) - all.width(s))));
}

FrontSequence::FrontSequence(const Supernodes& all) : branches_(index(all.count())) {
  std::vector<std::size_t> room(index(all.count()));
  std::vector<int> next;  // to be eliminated after all that is in the sequence already, if read from its end
  for (int s = 0; s < all.count(); ++s) {
    std::vector<int>& branches = branches_[index(s)];
    std::stable_sort(branches.begin(), branches.end(), [&](int a, int b) {
      return room[index(a)] - values_left(all, a) > room[index(b)] - values_left(all, b);
    });
    std::size_t waiting = 0;
    for (const int branch : branches) {
      room[index(s)] = std::max(room[index(s)], waiting + room[index(branch)]);
      waiting += values_left(all, branch);
    }
    room[index(s)] = std::max(room[index(s)], waiting + values_of_columns(all, s) + values_left(all, s));
    room_ = std::max(room_, room[index(s)]);
    const int parent = all.parent(s);
    (parent < 0 ? next : branches_[index(parent)]).push_back(s);
  }
  while (!next.empty()) {
    const int s = next.back();
    next.pop_back();
    supernodes_.push_back(s);
    next.insert(next.end(), branches_[index(s)].begin(), branches_[index(s)].end());
  }
  std::reverse(supernodes_.begin(), supernodes_.end());
}

}  // namespace wale
