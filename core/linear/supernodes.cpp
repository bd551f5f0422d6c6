// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/supernodes.h"

#include <cstddef>
#include <limits>

namespace foldless {
namespace {

/// Up to so many nodes a supernode, as large a part of its values may be zeros that are stored.
struct Relaxation {
  int nodes;
  double zeros;
};
constexpr Relaxation kRelaxations[] = {
    {2, 1.0}, {8, 0.8}, {24, 0.1}, {std::numeric_limits<int>::max(), 0.05}};

/// A supernode while others are merged into it.
struct Growing {
  NodeRange range;
  int parent = -1;   ///< among the fundamental ones
  double zeros = 0;  ///< stored
  int merged = -1;   ///< the one that took it in
};

std::size_t at(int i) { return static_cast<std::size_t>(i); }

std::vector<Growing> fundamental_supernodes(const EliminationTree& tree) {
  const int nodes = static_cast<int>(tree.parent.size());
  std::vector<int> children(tree.parent.size(), 0), of_node(tree.parent.size());
  for (const int p : tree.parent)
    if (p >= 0) ++children[at(p)];
  std::vector<Growing> found;
  for (int k = 0; k < nodes; ++k) {
    const bool goes_on = k > 0 && tree.parent[at(k) - 1] == k && children[at(k)] == 1 &&
                         tree.count[at(k) - 1] == tree.count[at(k)] + 1;
    if (!goes_on) found.push_back({{k, 0, 0}});
    NodeRange& range = found.back().range;
    ++range.nodes;
    range.below = tree.count[at(k)] - 1;
    of_node[at(k)] = static_cast<int>(found.size()) - 1;
  }
  for (Growing& s : found) {
    const int up = tree.parent[at(s.range.first + s.range.nodes - 1)];
    s.parent = up < 0 ? -1 : of_node[at(up)];
  }
  return found;
}

/// Merges a child with the supernode right after it, its parent, where that stores few zeros.
bool merge(Growing& child, const Growing& into) {
  const double nodes = child.range.nodes + into.range.nodes;
  // Every column of the child gets the rows that `into` has and it lacks.
  const double new_zeros = static_cast<double>(child.range.nodes) *
                           (into.range.nodes + into.range.below - child.range.below);
  const double zeros = child.zeros + into.zeros + new_zeros;
  const double size = nodes * (nodes + 1) / 2 + nodes * into.range.below;
  bool worth_while = new_zeros == 0;
  for (const Relaxation& r : kRelaxations)
    worth_while = worth_while || (nodes <= r.nodes && zeros < r.zeros * size);
  if (!worth_while) return false;
  child.range.nodes += into.range.nodes;
  child.range.below = into.range.below;
  child.zeros = zeros;
  return true;
}

}  // namespace

std::vector<NodeRange> relaxed_supernodes(const EliminationTree& tree) {
  std::vector<Growing> all = fundamental_supernodes(tree);
  const auto taker_of = [&](int s) {
    while (all[at(s)].merged >= 0) {
      int& taker = all[at(s)].merged;
      const int next = all[at(taker)].merged;
      if (next < 0) return taker;
      s = taker = next;
    }
    return s;
  };
  for (int s = static_cast<int>(all.size()) - 2; s >= 0; --s) {
    if (all[at(s)].parent < 0) continue;
    const int next = s + 1;  // what was merged goes by its first: this one was not taken in
    if (taker_of(all[at(s)].parent) != next) continue;
    if (merge(all[at(s)], all[at(next)])) all[at(next)].merged = s;
  }
  std::vector<NodeRange> ranges;
  for (const Growing& s : all)
    if (s.merged < 0) ranges.push_back(s.range);
  return ranges;
}

}  // namespace foldless
