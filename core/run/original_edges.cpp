// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/original_edges.h"

#include <algorithm>
#include <numeric>

#include "core/threads/values_of_ranges.h"

namespace foldless {
namespace {

/// Calls visit(edge) for the three edges of every triangle, an expression like Triangles.
template <class Some, class Visit>
void for_each_edge(const Some& triangles, const Visit& visit) {
  for (const auto& t : triangles.colwise())
    for (int k = 0; k < 3; ++k) {
      const int a = t[k];
      const int b = t[(k + 1) % 3];
      visit(Edge{std::min(a, b), std::max(a, b)});
    }
}

}  // namespace

OriginalEdges::OriginalEdges(const Triangles& triangles, int vertices)
    : first_(static_cast<std::size_t>(vertices) + 1, 0) {
  for_each_edge(triangles, [&](const Edge& e) { ++first_[static_cast<std::size_t>(e[0]) + 1]; });
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  larger_.resize(static_cast<std::size_t>(first_.back()));
  std::vector<int> next = first_;
  for_each_edge(triangles, [&](const Edge& e) {
    larger_[static_cast<std::size_t>(next[static_cast<std::size_t>(e[0])]++)] = e[1];
  });
}

bool OriginalEdges::contains(const Edge& edge) const {
  const auto a = static_cast<std::size_t>(edge[0]);
  const auto begin = larger_.begin() + first_[a];
  const auto end = larger_.begin() + first_[a + 1];
  return std::find(begin, end, edge[1]) != end;
}

std::vector<Edge> OriginalEdges::flipped_in(const Triangles& triangles) const {
  const int vertices = static_cast<int>(first_.size()) - 1;
  constexpr std::ptrdiff_t kTrianglesTogether = 8192;
  std::vector<Edge> flipped = joined_ranges(
      triangles.cols(), kTrianglesTogether, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
        std::vector<Edge> found;
        for_each_edge(triangles.middleCols(begin, end - begin), [&](const Edge& e) {
          if (e[1] < vertices && !contains(e)) found.push_back(e);
        });
        return found;
      });
  std::ranges::sort(flipped);
  flipped.erase(std::unique(flipped.begin(), flipped.end()), flipped.end());
  return flipped;
}

}  // namespace foldless
