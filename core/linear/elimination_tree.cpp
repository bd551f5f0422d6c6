// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/elimination_tree.h"

#include <algorithm>
#include <numeric>

namespace foldless {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// Liu's algorithm with path compression.
std::vector<int> parents_of(const ItemLists<BlockOfNode>& blocks) {
  const int nodes = blocks.count();
  std::vector<int> parent(index(nodes), -1), ancestor(index(nodes), -1);
  for (int k = 0; k < nodes; ++k)
    for (const BlockOfNode& block : blocks.of(k))
      for (int j = block.other; j < k;) {
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
  const std::vector<int> position = places_in(order);
  std::vector<int> result(parent.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const int p = parent[index(order[k])];
    result[k] = p < 0 ? -1 : position[index(p)];
  }
  return result;
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

std::vector<int> column_counts(const ItemLists<BlockOfNode>& blocks,
                               const std::vector<int>& parent) {
  const int nodes = static_cast<int>(parent.size());
  RowSubtrees subtrees(parent);
  std::vector<int> count(parent.size());
  for (int j = 0; j < nodes; ++j) count[index(j)] = subtrees.is_leaf_of_the_tree(j) ? 1 : 0;
  for (int j = 0; j < nodes; ++j) {
    const int p = parent[index(j)];
    if (p >= 0) --count[index(p)];
    for (const BlockOfNode& block : blocks.of(j)) {
      int meeting = -1;
      if (block.other < j || !subtrees.is_next_leaf(block.other, j, meeting)) continue;
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
  tree.blocks = in_order(blocks_of_nodes(matrix), order);
  tree.parent = parents_of(tree.blocks);
  if (const std::vector<int> post = postorder(tree.parent); !std::ranges::is_sorted(post)) {
    tree.parent = relabelled(tree.parent, post);
    std::ranges::transform(post, tree.order.begin(), [&](int k) { return order[index(k)]; });
    tree.blocks = in_order(tree.blocks, post);
  }
  tree.count = column_counts(tree.blocks, tree.parent);
  return tree;
}

}  // namespace foldless
