// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/symbolic_analysis.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "core/error.h"
#include "core/linear/elimination_tree.h"
#include "core/linear/supernodes.h"
#include "core/linear/work_plan.h"
#include "core/threads/team.h"

namespace foldless {
namespace {

/// Fills a symbolic factor in, from the supernodes on.
class FactorBuilder {
 public:
  FactorBuilder(const EliminationTree& tree, SymbolicFactor& factor)
      : tree_(tree), factor_(factor) {}

  void make_supernodes() {
    std::size_t rows = 0;
    for (const NodeRange& range : relaxed_supernodes(tree_)) {
      Supernode s;
      s.first = 2 * range.first;
      s.columns = 2 * range.nodes;
      s.below = 2 * range.below;
      s.row_start = rows;
      s.value_start = factor_.values;
      const std::size_t size = at(s.rows()) * at(s.columns);
      if (size > static_cast<std::size_t>(std::numeric_limits<int>::max()))
        throw Error("the mesh has too many triangles for the solver; use a coarser one");
      rows += at(range.below);
      factor_.values += size;
      factor_.largest_front = std::max(factor_.largest_front, s.rows());
      of_node_.resize(of_node_.size() + at(range.nodes),
                      static_cast<int>(factor_.supernodes.size()));
      factor_.supernodes.push_back(s);
    }
    factor_.rows.resize(rows);
    factor_.places.resize(rows);
  }

  void link() {
    for (std::size_t k = factor_.supernodes.size(); k-- > 0;) {
      Supernode& s = factor_.supernodes[k];
      const int up = tree_.parent[static_cast<std::size_t>((s.first + s.columns) / 2 - 1)];
      if (up < 0) continue;
      s.parent = of_node_[at(up)];
      Supernode& parent = supernode(s.parent);
      s.sibling = parent.child;
      parent.child = static_cast<int>(k);
    }
  }

  /// Row i is in the supernodes on the paths from the earlier neighbours of i up to i.
  /// Precondition: subtrees and top are known.
  void find_rows() {
    last_row_.assign(factor_.supernodes.size(), -1);
    next_.reserve(factor_.supernodes.size());
    for (const Supernode& s : factor_.supernodes) next_.push_back(s.row_start);
    in_parallel(static_cast<int>(factor_.subtrees.size()),
                [&](int k) { find_rows_in(factor_.subtrees[at(k)]); });
    find_rows_of_top();
  }

  void find_places() {
    const auto count = std::ssize(factor_.supernodes);
    std::vector<std::size_t> sizes(factor_.supernodes.size());
    each_in_ranges(count, kSupernodesTogether, [&](std::ptrdiff_t k) {
      const auto place = static_cast<std::size_t>(k);
      sizes[place] = count_blocks(factor_.supernodes[place]);
    });
    std::size_t all = 0;
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      factor_.supernodes[k].block_start = all;
      all += sizes[k];
    }
    factor_.blocks.resize(all);
    constexpr std::ptrdiff_t kRanges = 16;
    in_ranges(count, std::max(kSupernodesTogether, count / kRanges),
              [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
                UnfilledVector<int> place(of_node_.size());  // of nodes in a front
                for (std::ptrdiff_t k = begin; k < end; ++k)
                  find_places(factor_.supernodes[static_cast<std::size_t>(k)], place);
              });
  }

 private:
  /// Rows beyond the subtree come last, in their order.
  void find_rows_in(const Subtree& subtree) {
    const Supernode& root = supernode(subtree.root);
    const int begin = supernode(subtree.first).first / 2, end = (root.first + root.columns) / 2;
    std::vector<std::pair<int, int>> beyond;  // rows, and supernodes to climb from
    for (int i = begin; i < end; ++i) {
      const int k = of_node_[at(i)];
      for (const BlockOfNode& block : tree_.blocks.of(i))
        if (block.other < i)
          climb(i, of_node_[at(block.other)], k);
        else if (block.other >= end)
          beyond.emplace_back(block.other, k);
    }
    std::ranges::sort(beyond);
    for (const auto& [row, k] : beyond) climb(row, k, root.parent);
  }

  /// Paths from a subtree up to the top are known to lead through its root.
  void find_rows_of_top() {
    std::vector<int> from(factor_.supernodes.size());
    std::iota(from.begin(), from.end(), 0);
    for (const Subtree& subtree : factor_.subtrees)
      std::fill(from.begin() + subtree.first, from.begin() + subtree.root + 1,
                supernode(subtree.root).parent);
    for (const int k : factor_.top)
      for (int i = supernode(k).first / 2, n = supernode(k).columns / 2; n-- > 0; ++i)
        for (const BlockOfNode& block : tree_.blocks.of(i))
          if (block.other < i) climb(i, from[at(of_node_[at(block.other)])], k);
  }

  /// Puts a row into the supernodes from one of them up to below another, or to where it is in.
  void climb(int row, int k, int end) {
    for (; k != end && last_row_[at(k)] != row; k = supernode(k).parent) {
      last_row_[at(k)] = row;
      factor_.rows[next_[at(k)]++] = row;
    }
  }

  std::size_t count_blocks(const Supernode& s) const {
    std::size_t count = 0;
    for (int node = s.first / 2; node < (s.first + s.columns) / 2; ++node)
      for (const BlockOfNode& block : tree_.blocks.of(node)) count += block.other > node ? 1 : 0;
    return count;
  }

  void find_places(const Supernode& s, UnfilledVector<int>& place) {
    int count = 0;
    for (int i = s.first / 2; count < s.columns / 2; ++i) place[at(i)] = count++;
    for (const int i : factor_.rows_of(s)) place[at(i)] = count++;
    for (int k = s.child; k >= 0; k = supernode(k).sibling) {
      std::size_t next = supernode(k).row_start;
      for (const int i : factor_.rows_of(supernode(k))) factor_.places[next++] = place[at(i)];
    }
    BlockOfPanel* next = factor_.blocks.data() + s.block_start;
    for (int k = 0; k < s.columns / 2; ++k) {
      const int node = s.first / 2 + k;
      for (const BlockOfNode& block : tree_.blocks.of(node)) {
        if (block.other < node) continue;
        const int target = 2 * (k * s.rows() + place[at(block.other)]);
        const auto& [first, second] = block.place;
        *next++ = {first, second, is_transposed(node, block.other) ? ~target : target};
      }
    }
  }

  /// Of the block of two places: whether its row is the node that comes first.
  bool is_transposed(int earlier, int later) const {
    return tree_.order[at(earlier)] > tree_.order[at(later)];
  }

  Supernode& supernode(int k) { return factor_.supernodes[at(k)]; }
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  static constexpr std::ptrdiff_t kSupernodesTogether = 512;

  const EliminationTree& tree_;
  SymbolicFactor& factor_;
  std::vector<int> of_node_;  ///< the supernode of every place
  /// While rows are found, by supernodes: the last one, and where the next goes.
  std::vector<int> last_row_;
  std::vector<std::size_t> next_;
};

}  // namespace

SymbolicFactor symbolic_factor(EliminationTree tree, double parted_from) {
  SymbolicFactor factor;
  FactorBuilder builder(tree, factor);
  builder.make_supernodes();
  builder.link();
  find_subtrees(factor, parted_from);
  builder.find_rows();
  builder.find_places();
  factor.order = std::move(tree.order);
  factor.place = places_in(factor.order);
  factor.parent = std::move(tree.parent);
  plan_work(factor);
  return factor;
}

}  // namespace foldless
