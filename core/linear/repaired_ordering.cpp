// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/repaired_ordering.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/linear/blocks_of_nodes.h"
#include "core/threads/values_of_ranges.h"

namespace foldless {
namespace {

std::size_t place(int i) { return static_cast<std::size_t>(i); }

/// Places are those of the order before. A node that is to be eliminated later has a place above it
/// before which it comes.
class Repair {
 public:
  explicit Repair(const std::vector<int>& parent)
      : parent_(parent), first_(parent.size()), before_(parent.size(), -1) {
    for (std::size_t k = 0; k < parent.size(); ++k) first_[k] = static_cast<int>(k);
    for (std::size_t k = 0; k < parent.size(); ++k)
      if (parent[k] >= 0) first_[place(parent[k])] = std::min(first_[place(parent[k])], first_[k]);
  }

  /// Whether a is b or one of its descendants.
  bool is_below(int a, int b) const { return first_[place(b)] <= a && a <= b; }

  /// Makes room for an edge between these places, a < b, where a is not below b.
  void connect(int a, int b) {
    int meeting = b, steps_of_b = 0;
    for (; meeting >= 0 && !is_below(a, meeting); meeting = parent_[place(meeting)]) ++steps_of_b;
    if (meeting < 0) meeting = static_cast<int>(parent_.size());
    if (before_[place(a)] >= meeting || before_[place(b)] >= meeting) return;
    const bool moves_a = moves(a) || (!moves(b) && are_fewer_steps(a, meeting, steps_of_b));
    move(moves_a ? a : b, meeting);
  }

  bool is_empty() const { return movers_.empty(); }

  std::vector<int> new_order(const std::vector<int>& order) {
    std::ranges::sort(movers_, {}, [&](int k) { return std::pair(before_[place(k)], k); });
    std::vector<int> result;
    result.reserve(order.size());
    auto next = movers_.begin();
    for (int k = 0; k <= static_cast<int>(order.size()); ++k) {
      for (; next != movers_.end() && before_[place(*next)] == k; ++next)
        result.push_back(order[place(*next)]);
      if (k < static_cast<int>(order.size()) && !moves(k)) result.push_back(order[place(k)]);
    }
    return result;
  }

 private:
  bool moves(int k) const { return before_[place(k)] >= 0; }

  void move(int k, int before) {
    if (!moves(k)) movers_.push_back(k);
    before_[place(k)] = before;
  }

  /// Whether it is not more than so many steps up from k to `meeting`. Every front on the way of
  /// what moves gets a row.
  bool are_fewer_steps(int k, int meeting, int than) const {
    int steps = 0;
    for (; k >= 0 && k != meeting && steps <= than; k = parent_[place(k)]) ++steps;
    return steps <= than;
  }

  const std::vector<int>& parent_;
  std::vector<int> first_;   ///< the first of the descendants
  std::vector<int> before_;  ///< −1: it stays
  std::vector<int> movers_;
};

}  // namespace

std::vector<int> repaired_ordering(const SparseSymmetric& matrix, const std::vector<int>& order,
                                   const std::vector<int>& parent) {
  const std::vector<int> position = places_in(order);
  Repair repair(parent);
  constexpr std::ptrdiff_t kNodesTogether = 4096;
  const std::vector<std::pair<int, int>> unconnected =
      joined_ranges(matrix.nodes, kNodesTogether, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
        std::vector<std::pair<int, int>> found;
        for (auto j = static_cast<std::size_t>(begin); j < static_cast<std::size_t>(end); ++j)
          for (int k = matrix.graph_start[j]; k < matrix.graph_start[j + 1]; ++k) {
            const auto [a, b] = std::minmax(position[j], position[place(matrix.graph[place(k)])]);
            if (!repair.is_below(a, b)) found.emplace_back(a, b);
          }
        return found;
      });
  for (const auto& [a, b] : unconnected) repair.connect(a, b);
  return repair.is_empty() ? order : repair.new_order(order);
}

}  // namespace foldless
