// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/work_plan.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

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

class Planner {
 public:
  explicit Planner(SymbolicFactor& factor)
      : factor_(factor),
        family_(factor.supernodes.size(), 1),
        is_odd_(factor.supernodes.size(), 0),
        is_root_(factor.supernodes.size(), 0) {
    for (std::size_t k = is_odd_.size(); k-- > 0;) {
      const int parent = factor.supernodes[k].parent;
      if (parent >= 0) is_odd_[k] = !is_odd_[as_index(parent)];
    }
  }

  void find_subtrees(double parted_from) {
    std::vector<double> work(factor_.supernodes.size(), 0);
    double all = 0;
    for (std::size_t k = 0; k < work.size(); ++k) {
      const Supernode& s = factor_.supernodes[k];
      all += multiplications(s);
      work[k] += multiplications(s);
      if (s.parent < 0) continue;
      work[as_index(s.parent)] += work[k];
      family_[as_index(s.parent)] += family_[k];
    }
    if (all < parted_from) return fill_top(0, static_cast<int>(work.size()));
    const double most = kLargestShare * all;
    int end = static_cast<int>(work.size());
    for (int k = end - 1; k >= 0; --k) {
      if (work[as_index(k)] > most) continue;
      const int first = k + 1 - family_[as_index(k)];
      factor_.subtrees.push_back({first, k, 0});
      is_root_[as_index(k)] = 1;
      fill_top(k + 1, end);
      k = end = first;
    }
    fill_top(0, end);
    std::ranges::reverse(factor_.subtrees);
    std::ranges::sort(factor_.top);
  }

  void number_outer_places() {
    factor_.solve_rows = factor_.rows;
    std::vector<int> place(factor_.order.size(), -1);
    for (Subtree& subtree : factor_.subtrees) {
      const Supernode& root = factor_.supernodes[as_index(subtree.root)];
      subtree.outer_start = factor_.outer;
      for (const int row : factor_.rows_of(root))
        place[as_index(row)] = static_cast<int>(place.size()) + factor_.outer++;
      const int end = (root.first + root.columns) / 2;
      for (std::size_t i = factor_.supernodes[as_index(subtree.first)].row_start;
           i < root.row_start + as_index(root.below / 2); ++i)
        if (factor_.rows[i] >= end) factor_.solve_rows[i] = place[as_index(factor_.rows[i])];
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
  void fill_top(int begin, int end) {
    for (int k = begin; k < end; ++k) factor_.top.push_back(k);
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
  std::vector<int> family_;    ///< supernodes of the subtree of each
  std::vector<char> is_odd_;   ///< depth of each
  std::vector<char> is_root_;  ///< of a subtree that is a task
};

}  // namespace

void plan_work(SymbolicFactor& factor, double parted_from) {
  Planner planner(factor);
  planner.find_subtrees(parted_from);
  planner.number_outer_places();
  planner.place_updates();
}

}  // namespace foldless
