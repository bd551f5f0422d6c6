// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/elimination_tree.h"

#include <algorithm>
#include <numeric>

namespace foldless {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

std::vector<int> inverse(const std::vector<int>& order) {
  std::vector<int> position(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) position[index(order[k])] = static_cast<int>(k);
  return position;
}

OrderedNeighbours earlier_neighbours(const SparseSymmetric& matrix,
                                     const std::vector<int>& position) {
  const auto visit = [&](const auto& put) {
    for (int j = 0; j < matrix.nodes; ++j)
      for (int k = matrix.graph_start[index(j)]; k < matrix.graph_start[index(j) + 1]; ++k) {
        const auto [first, second] =
            std::minmax(position[index(j)], position[index(matrix.graph[index(k)])]);
        put(first, second);
      }
  };
  OrderedNeighbours earlier;
  earlier.start.assign(index(matrix.nodes) + 1, 0);
  visit([&](int, int second) { ++earlier.start[index(second) + 1]; });
  std::partial_sum(earlier.start.begin(), earlier.start.end(), earlier.start.begin());
  earlier.place.resize(matrix.graph.size());
  std::vector<int> next(earlier.start.begin(), earlier.start.end() - 1);
  visit([&](int first, int second) { earlier.place[index(next[index(second)]++)] = first; });
  return earlier;
}

/// Liu's algorithm with path compression.
std::vector<int> parents_of(const OrderedNeighbours& earlier) {
  const int nodes = static_cast<int>(earlier.start.size()) - 1;
  std::vector<int> parent(index(nodes), -1), ancestor(index(nodes), -1);
  for (int k = 0; k < nodes; ++k)
    for (int j : earlier.of(k))
      while (j != k) {
        const int next = ancestor[index(j)];
        ancestor[index(j)] = k;
        if (next < 0) {
          parent[index(j)] = k;
          break;
        }
        j = next;
      }
  return parent;
}

std::vector<int> postorder(const std::vector<int>& parent) {
  const int nodes = static_cast<int>(parent.size());
  std::vector<int> child(parent.size(), -1), sibling(parent.size(), -1);
  for (int k = nodes - 1; k >= 0; --k) {
    const int p = parent[index(k)];
    if (p < 0) continue;
    sibling[index(k)] = child[index(p)];
    child[index(p)] = k;
  }
  std::vector<int> order, path;
  order.reserve(parent.size());
  for (int root = 0; root < nodes; ++root) {
    if (parent[index(root)] >= 0) continue;
    path.push_back(root);
    while (!path.empty()) {
      const int k = path.back(), next = child[index(k)];
      if (next >= 0) {
        child[index(k)] = sibling[index(next)];
        path.push_back(next);
      } else {
        order.push_back(k);
        path.pop_back();
      }
    }
  }
  return order;
}

std::vector<int> relabelled(const std::vector<int>& parent, const std::vector<int>& order) {
  const std::vector<int> position = inverse(order);
  std::vector<int> result(parent.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const int p = parent[index(order[k])];
    result[k] = p < 0 ? -1 : position[index(p)];
  }
  return result;
}

OrderedNeighbours later_neighbours(const OrderedNeighbours& earlier) {
  const int nodes = static_cast<int>(earlier.start.size()) - 1;
  OrderedNeighbours later;
  later.start.assign(earlier.start.size(), 0);
  for (const int j : earlier.place) ++later.start[index(j) + 1];
  std::partial_sum(later.start.begin(), later.start.end(), later.start.begin());
  later.place.resize(earlier.place.size());
  std::vector<int> next(later.start.begin(), later.start.end() - 1);
  for (int k = 0; k < nodes; ++k)
    for (const int j : earlier.of(k)) later.place[index(next[index(j)]++)] = k;
  return later;
}

/// The columns whose row i of the factor is not zero are a subtree that ends at i; its leaves tell
/// how many there are [GNP94].
class RowSubtrees {
 public:
  explicit RowSubtrees(const std::vector<int>& parent)
      : first_(parent.size(), -1),
        last_first_(parent.size(), -1),
        last_leaf_(parent.size(), -1),
        ancestor_(parent.size()) {
    std::iota(ancestor_.begin(), ancestor_.end(), 0);
    for (int k = 0; k < static_cast<int>(parent.size()); ++k)
      for (int j = k; j >= 0 && first_[index(j)] < 0; j = parent[index(j)]) first_[index(j)] = k;
  }

  bool is_leaf_of_the_tree(int j) const { return first_[index(j)] == j; }
  /// True when j is the next leaf of the subtree of row i; `meeting` is where its path meets that
  /// of the leaf before it, −1 where there is none.
  bool is_next_leaf(int i, int j, int& meeting) {
    if (first_[index(j)] <= last_first_[index(i)]) return false;
    last_first_[index(i)] = first_[index(j)];
    const int before = last_leaf_[index(i)];
    last_leaf_[index(i)] = j;
    meeting = before < 0 ? -1 : root_of(before);
    return true;
  }
  void set_done(int j, int parent) { ancestor_[index(j)] = parent; }

 private:
  int root_of(int k) {
    int root = k;
    while (root != ancestor_[index(root)]) root = ancestor_[index(root)];
    while (k != root) {
      const int next = ancestor_[index(k)];
      ancestor_[index(k)] = root;
      k = next;
    }
    return root;
  }

  std::vector<int> first_;  ///< descendant of a node
  std::vector<int> last_first_, last_leaf_, ancestor_;
};

std::vector<int> column_counts(const OrderedNeighbours& earlier, const std::vector<int>& parent) {
  const int nodes = static_cast<int>(parent.size());
  const OrderedNeighbours later = later_neighbours(earlier);
  RowSubtrees subtrees(parent);
  std::vector<int> count(parent.size());
  for (int j = 0; j < nodes; ++j) count[index(j)] = subtrees.is_leaf_of_the_tree(j) ? 1 : 0;
  for (int j = 0; j < nodes; ++j) {
    const int p = parent[index(j)];
    if (p >= 0) --count[index(p)];
    for (const int i : later.of(j)) {
      int meeting = -1;
      if (!subtrees.is_next_leaf(i, j, meeting)) continue;
      ++count[index(j)];
      if (meeting >= 0) --count[index(meeting)];
    }
    if (p >= 0) subtrees.set_done(j, p);
  }
  for (int j = 0; j < nodes; ++j)
    if (parent[index(j)] >= 0) count[index(parent[index(j)])] += count[index(j)];
  return count;
}

}  // namespace

EliminationTree elimination_tree(const SparseSymmetric& matrix, const std::vector<int>& order) {
  EliminationTree tree;
  tree.order = order;
  tree.position = inverse(order);
  tree.earlier = earlier_neighbours(matrix, tree.position);
  tree.parent = parents_of(tree.earlier);
  if (const std::vector<int> post = postorder(tree.parent); !std::ranges::is_sorted(post)) {
    tree.parent = relabelled(tree.parent, post);
    std::ranges::transform(post, tree.order.begin(), [&](int k) { return order[index(k)]; });
    tree.position = inverse(tree.order);
    tree.earlier = earlier_neighbours(matrix, tree.position);
  }
  tree.count = column_counts(tree.earlier, tree.parent);
  return tree;
}

}  // namespace foldless
