// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>

#include "core/linear/symbolic_factor.h"
#include "core/threads/team.h"

namespace foldless {

/// A vector in the order of elimination with its outer places, and scratch space.
template <class Value>
struct SweptVector {
  Value* x;         ///< factor.solve_size() values
  Value* work;      ///< sweep_work_size(factor, overrun) values
  int overrun = 0;  ///< so many values more than a front's rows are touched in its scratch space
};

/// Scratch values of a front.
inline std::size_t front_work_size(const SymbolicFactor& factor, int overrun) {
  return static_cast<std::size_t>(factor.largest_front) + static_cast<std::size_t>(overrun);
}
/// Scratch space of sweep(): a front's for every subtree and the top.
inline std::size_t sweep_work_size(const SymbolicFactor& factor, int overrun) {
  return (factor.subtrees.size() + 1) * front_work_size(factor, overrun);
}

/// Solves L Lᵀ x = b: calls forward(supernode, x, work) for all supernodes, children before
/// parents, and then backward(supernode, x, work) for all, parents before children. Subtrees go at
/// the same time; what they do to rows above them goes by their outer places, in their order.
template <class Value, class Forward, class Backward>
void sweep(const SymbolicFactor& factor, SweptVector<Value> vector, const Forward& forward,
           const Backward& backward) {
  const auto count = static_cast<int>(factor.subtrees.size());
  const auto visit_outer = [&](int i, const auto& visit) {
    const Subtree& subtree = factor.subtrees[static_cast<std::size_t>(i)];
    const Supernode& root = factor.supernodes[static_cast<std::size_t>(subtree.root)];
    Value* outer = vector.x + factor.size() + 2 * static_cast<std::ptrdiff_t>(subtree.outer_start);
    for (const int row : factor.rows_of(root)) {
      visit(vector.x + 2 * static_cast<std::ptrdiff_t>(row), outer);
      outer += 2;
    }
  };
  const auto work_of = [&](int i) {
    return vector.work + static_cast<std::size_t>(i) * front_work_size(factor, vector.overrun);
  };
  const auto supernode = [&](int k) -> const Supernode& {
    return factor.supernodes[static_cast<std::size_t>(k)];
  };
  std::fill_n(vector.x + factor.size(), 2 * static_cast<std::size_t>(factor.outer), Value{0});
  in_parallel(count, [&](int i) {
    const Subtree& subtree = factor.subtrees[static_cast<std::size_t>(i)];
    for (int k = subtree.first; k <= subtree.root; ++k) forward(supernode(k), vector.x, work_of(i));
  });
  for (int i = 0; i < count; ++i)
    visit_outer(i, [](Value* x, const Value* outer) {
      x[0] += outer[0];
      x[1] += outer[1];
    });
  for (const int k : factor.top) forward(supernode(k), vector.x, work_of(count));
  for (std::size_t k = factor.top.size(); k-- > 0;)
    backward(supernode(factor.top[k]), vector.x, work_of(count));
  in_parallel(count, [&](int i) {
    visit_outer(i, [](const Value* x, Value* outer) {
      outer[0] = x[0];
      outer[1] = x[1];
    });
    const Subtree& subtree = factor.subtrees[static_cast<std::size_t>(i)];
    for (int k = subtree.root; k >= subtree.first; --k)
      backward(supernode(k), vector.x, work_of(i));
  });
}

}  // namespace foldless
