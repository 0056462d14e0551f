#include "sim/solvers/dissection.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "sim/solvers/cholmod.hpp"

namespace wale {
namespace {

constexpr double least_part = 0.3;     // of the points, in the smaller of two parts
constexpr double widest_border = 0.2;  // of the points

std::size_t index(int i) { return static_cast<std::size_t>(i); }

struct Graph {
  std::vector<int> start{0}, row;
  cholmod_sparse view() { return cholmod::lower_triangle(start, row, nullptr); }
};

Graph graph_of(const Stiffness& K, const UsedBlocks& used) {
  Graph graph;
  for (int j = 0; j < K.points(); ++j) {
    for (const Stiffness::Entry& entry : K.row(j))
      if (entry.column >= j && used.has(j, entry)) graph.row.push_back(entry.column);
    graph.start.push_back(static_cast<int>(graph.row.size()));
  }
  return graph;
}

/// A tree of separators: each component parts those below it.
struct SeparatorTree {
  std::vector<int> order;      // of points
  std::vector<int> component;  // of each point
  std::vector<int> parent;     // of each component; -1 of a root
};

SeparatorTree nested(Graph& graph) {
  cholmod::Common common;
  cholmod_sparse view = graph.view();
  const std::size_t points = view.nrow;
  SeparatorTree tree{std::vector<int>(points), std::vector<int>(points), std::vector<int>(points)};
  const auto components = cholmod_nested_dissection(&view, nullptr, 0, tree.order.data(), tree.parent.data(),
                                                    tree.component.data(), common.get());
  if (components < 0) throw std::bad_alloc();
  tree.parent.resize(static_cast<std::size_t>(components));
  return tree;
}

/// The border is the one root, or nothing if there are several; what hangs below goes to the smaller part in turn.
Dissection halves(const SeparatorTree& tree) {
  const auto roots = std::count(tree.parent.begin(), tree.parent.end(), -1);
  const auto has_border = roots == 1 && tree.parent.size() > 1;
  const auto is_top = [&](int component) {
    const int above = tree.parent[index(component)];
    return has_border ? above >= 0 && tree.parent[index(above)] < 0 : above < 0;
  };
  const auto is_border = [&](int component) { return has_border && tree.parent[index(component)] < 0; };
  std::vector<int> top(tree.parent.size()), size(tree.parent.size());
  for (const int point : tree.order) {
    int component = tree.component[index(point)];
    if (is_border(component)) continue;
    while (!is_top(component)) component = tree.parent[index(component)];
    top[index(tree.component[index(point)])] = component;
    ++size[index(component)];
  }
  std::vector<int> largest_first(size.size()), part(size.size());
  std::iota(largest_first.begin(), largest_first.end(), 0);
  std::stable_sort(largest_first.begin(), largest_first.end(),
                   [&](int a, int b) { return size[index(a)] > size[index(b)]; });
  std::array<int, 2> points{};
  for (const int component : largest_first) {
    part[index(component)] = points[0] <= points[1] ? 0 : 1;
    points[index(part[index(component)])] += size[index(component)];
  }
  Dissection found{std::vector<std::vector<int>>(2), {}};
  for (const int point : tree.order) {
    const int component = tree.component[index(point)];
    if (is_border(component))
      found.border.push_back(point);
    else
      found.parts[index(part[index(top[index(component)])])].push_back(point);
  }
  return found;
}

bool is_balanced(const Dissection& halves) {
  const auto of = [](const std::vector<int>& points) { return static_cast<double>(points.size()); };
  const double a = of(halves.parts[0]), b = of(halves.parts[1]), border = of(halves.border), all = a + b + border;
  return std::min(a, b) > least_part * all && border < widest_border * all;
}

}  // namespace

Dissection dissect(const Stiffness& K, const UsedBlocks& used) {
  Graph graph = graph_of(K, used);
  if (K.points() < many_points) return {{cholmod::order_of(graph.view(), CHOLMOD_AMD)}, {}};
  SeparatorTree tree = nested(graph);
  Dissection found = halves(tree);
  if (!is_balanced(found)) return {{std::move(tree.order)}, {}};
  return found;
}

bool separates(const Dissection& dissection, const Stiffness& K, const UsedBlocks& used) {
  if (dissection.parts.size() < 2) return true;
  std::vector<int> part(static_cast<std::size_t>(K.points()), -1);
  for (std::size_t p = 0; p < dissection.parts.size(); ++p)
    for (const int point : dissection.parts[p]) part[index(point)] = static_cast<int>(p);
  for (int i = 0; i < K.points(); ++i)
    for (const Stiffness::Entry& entry : K.row(i)) {
      const int mine = part[index(i)], other = part[index(entry.column)];
      if (mine >= 0 && other >= 0 && mine != other && used.has(i, entry)) return false;
    }
  return true;
}

}  // namespace wale
