// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <queue>
#include <tuple>
#include <vector>

namespace foldless {

/// Edges in descending order of what flipping them gains (4.3). Edges of equal gain come in the
/// order of their indices, so that runs are reproducible.
class EdgeHeap {
 public:
  /// `edge_count` bounds the indices that may be pushed, each at most once.
  explicit EdgeHeap(int edge_count) : present_(static_cast<std::size_t>(edge_count), false) {}

  void push(int edge, double gain) {
    present_[static_cast<std::size_t>(edge)] = true;
    queue_.emplace(gain, -edge);
  }
  /// Takes an edge out if it is there.
  void erase(int edge) { present_[static_cast<std::size_t>(edge)] = false; }
  /// Takes out the edge of the largest gain; nothing when empty.
  std::optional<int> pop() {
    while (!queue_.empty()) {
      const int edge = -std::get<1>(queue_.top());
      queue_.pop();
      if (!present_[static_cast<std::size_t>(edge)]) continue;
      erase(edge);
      return edge;
    }
    return std::nullopt;
  }

 private:
  std::vector<bool> present_;
  std::priority_queue<std::tuple<double, int>> queue_;
};

}  // namespace foldless
