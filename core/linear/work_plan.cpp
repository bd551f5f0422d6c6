// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/work_plan.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

#include "core/threads/team.h"

namespace foldless {
namespace {

/// Subtrees have a sixteenth of the multiplications at most: some more of them than there are
/// threads to share them, and no more above them than must be.
constexpr double kLargestShare = 1.0 / 16;

std::size_t as_index(int i) { return static_cast<std::size_t>(i); }

/// Multiplications of a supernode's front.
double multiplications(const Supernode& s) {
  const double rows = s.rows(), below = s.below;
  return (rows * rows * rows - below * below * below) / 3;
}

/// Supernodes that are in no subtree, among them.
void fill_top(SymbolicFactor& factor, int begin, int end) {
  for (int k = begin; k < end; ++k) factor.top.push_back(k);
}

class Planner {
 public:
  explicit Planner(SymbolicFactor& factor)
      : factor_(factor),
        is_odd_(factor.supernodes.size(), 0),
        is_root_(factor.supernodes.size(), 0) {
    for (std::size_t k = is_odd_.size(); k-- > 0;) {
      const int parent = factor.supernodes[k].parent;
      if (parent >= 0) is_odd_[k] = !is_odd_[as_index(parent)];
    }
    for (const Subtree& subtree : factor.subtrees) is_root_[as_index(subtree.root)] = 1;
  }

  void number_outer_places() {
    factor_.solve_rows.resize(factor_.rows.size());
    for (Subtree& subtree : factor_.subtrees) {
      subtree.outer_start = factor_.outer;
      factor_.outer += factor_.supernodes[as_index(subtree.root)].below / 2;
    }
    in_parallel(static_cast<int>(factor_.subtrees.size()),
                [&](int k) { number_outer_places_of(factor_.subtrees[as_index(k)]); });
    for (const int k : factor_.top) {
      const std::span<const int> rows = factor_.rows_of(factor_.supernodes[as_index(k)]);
      std::ranges::copy(rows, factor_.solve_rows.data() + (rows.data() - factor_.rows.data()));
    }
  }

  /// A subtree has stacks only while somebody works on it, and a place for what its root hands up.
  void place_updates() {
    std::vector<int> all(factor_.supernodes.size());
    std::iota(all.begin(), all.end(), 0);
    for (const Subtree& subtree : factor_.subtrees) {
      Supernode& root = factor_.supernodes[as_index(subtree.root)];
      const std::size_t size = stack_updates(
          std::span(all).subspan(as_index(subtree.first), as_index(subtree.root - subtree.first)),
          0);
      factor_.subtree_updates = std::max(factor_.subtree_updates, size);
      root.update_start = factor_.updates;
      factor_.updates += update_size(root);
    }
    factor_.updates += stack_updates(factor_.top, factor_.updates);
  }

 private:
  void number_outer_places_of(const Subtree& subtree) {
    const Supernode& root = factor_.supernodes[as_index(subtree.root)];
    UnfilledVector<int> place(factor_.order.size());
    int next = factor_.size() / 2 + subtree.outer_start;
    for (const int row : factor_.rows_of(root)) place[as_index(row)] = next++;
    const int end = (root.first + root.columns) / 2;
    for (std::size_t i = factor_.supernodes[as_index(subtree.first)].row_start;
         i < root.row_start + as_index(root.below / 2); ++i) {
      const int row = factor_.rows[i];
      factor_.solve_rows[i] = row < end ? row : place[as_index(row)];
    }
  }

  static std::size_t update_size(const Supernode& s) {
    return as_index(s.below) * as_index(s.below);
  }

  /// A parent's update matrix is made while those of its children are there: they are in the other
  /// one of two stacks, where they are the last. The stacks begin at `start`; returns their size.
  std::size_t stack_updates(std::span<const int> supernodes, std::size_t start) {
    std::size_t top[2] = {}, size[2] = {};
    for (const int k : supernodes) {
      Supernode& s = factor_.supernodes[as_index(k)];
      const std::size_t own = is_odd_[as_index(k)] ? 1 : 0;
      s.update_start = top[own];
      top[own] += update_size(s);
      size[own] = std::max(size[own], top[own]);
      const int child = first_stacked_child(s);
      if (child >= 0) top[1 - own] = factor_.supernodes[as_index(child)].update_start;
    }
    for (const int k : supernodes)
      factor_.supernodes[as_index(k)].update_start += start + (is_odd_[as_index(k)] ? size[0] : 0);
    return size[0] + size[1];
  }

  int first_stacked_child(const Supernode& s) const {
    int child = s.child;
    while (child >= 0 && is_root_[as_index(child)])
      child = factor_.supernodes[as_index(child)].sibling;
    return child;
  }

  SymbolicFactor& factor_;
  std::vector<char> is_odd_;   ///< depth of each
  std::vector<char> is_root_;  ///< of a subtree that is a task
};

}  // namespace

void find_subtrees(SymbolicFactor& factor, double parted_from) {
  const std::size_t count = factor.supernodes.size();
  std::vector<double> work(count, 0);  // of every supernode and what is below it
  std::vector<int> family(count, 1);   // how many these are
  double all = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const Supernode& s = factor.supernodes[k];
    all += multiplications(s);
    work[k] += multiplications(s);
    if (s.parent < 0) continue;
    work[as_index(s.parent)] += work[k];
    family[as_index(s.parent)] += family[k];
  }
  int end = static_cast<int>(count);
  for (int k = all < parted_from ? -1 : end - 1; k >= 0; --k) {
    if (work[as_index(k)] > kLargestShare * all) continue;
    const int first = k + 1 - family[as_index(k)];
    factor.subtrees.push_back({first, k, 0});
    fill_top(factor, k + 1, end);
    k = end = first;
  }
  fill_top(factor, 0, end);
  std::ranges::reverse(factor.subtrees);
  std::ranges::sort(factor.top);
}

void plan_work(SymbolicFactor& factor) {
  Planner planner(factor);
  planner.number_outer_places();
  planner.place_updates();
}

}  // namespace foldless
