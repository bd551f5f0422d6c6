// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/symbolic_analysis.h"

#include <algorithm>
#include <limits>

#include "core/error.h"
#include "core/linear/elimination_tree.h"
#include "core/linear/later_blocks.h"
#include "core/linear/supernodes.h"
#include "core/linear/work_plan.h"

namespace foldless {
namespace {

/// Fills a symbolic factor in, from the supernodes on.
class FactorBuilder {
 public:
  FactorBuilder(const SparseSymmetric& matrix, const EliminationTree& tree, SymbolicFactor& factor)
      : tree_(tree), later_(later_blocks(matrix, tree.position)), factor_(factor) {}

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
  void find_rows() {
    std::vector<int> last_row(factor_.supernodes.size(), -1);
    std::vector<std::size_t> next;
    for (const Supernode& s : factor_.supernodes) next.push_back(s.row_start);
    for (int i = 0; i < static_cast<int>(of_node_.size()); ++i) {
      const int end = of_node_[at(i)];
      for (const int j : tree_.earlier.of(i))
        for (int k = of_node_[at(j)]; k != end && last_row[at(k)] != i; k = supernode(k).parent) {
          last_row[at(k)] = i;
          factor_.rows[next[at(k)]++] = i;
        }
    }
  }

  void find_places() {
    std::vector<int> place(of_node_.size());
    for (Supernode& s : factor_.supernodes) {
      int count = 0;
      for (int i = s.first / 2; count < s.columns / 2; ++i) place[at(i)] = count++;
      for (const int i : factor_.rows_of(s)) place[at(i)] = count++;
      for (int k = s.child; k >= 0;) {
        const Supernode& child = supernode(k);
        std::size_t next = child.row_start;
        for (const int i : factor_.rows_of(child)) factor_.places[next++] = place[at(i)];
        k = child.sibling;
      }
      place_blocks(s, place);
    }
  }

 private:
  void place_blocks(Supernode& s, const std::vector<int>& place) {
    s.block_start = factor_.blocks.size();
    for (int k = 0; k < s.columns / 2; ++k)
      for (const LaterBlock& block : later_.of(s.first / 2 + k)) {
        const int target = 2 * (k * s.rows() + place[at(block.row)]);
        factor_.blocks.push_back(
            {block.first, block.second, block.is_transposed ? ~target : target});
      }
  }

  Supernode& supernode(int k) { return factor_.supernodes[at(k)]; }
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  const EliminationTree& tree_;
  const LaterBlocks later_;
  SymbolicFactor& factor_;
  std::vector<int> of_node_;  ///< the supernode of every place
};

}  // namespace

SymbolicFactor symbolic_factor(const SparseSymmetric& matrix, EliminationTree tree,
                               double parted_from) {
  SymbolicFactor factor;
  FactorBuilder builder(matrix, tree, factor);
  builder.make_supernodes();
  builder.link();
  builder.find_rows();
  builder.find_places();
  factor.order = std::move(tree.order);
  factor.parent = std::move(tree.parent);
  plan_work(factor, parted_from);
  return factor;
}

}  // namespace foldless
