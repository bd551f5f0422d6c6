// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/drawing_order.h"

#include <algorithm>
#include <numeric>

namespace foldless {
namespace {

/// The triangles of every vertex, one after another.
struct Incidence {
  std::vector<int> first;  ///< vertex → its entries, one past the last for #V
  std::vector<int> triangles;
};

Incidence incidence_of(const Triangles& triangles, std::size_t vertices) {
  Incidence incidence;
  incidence.first.assign(vertices + 1, 0);
  for (const int v : triangles.reshaped()) ++incidence.first[static_cast<std::size_t>(v) + 1];
  std::partial_sum(incidence.first.begin(), incidence.first.end(), incidence.first.begin());
  incidence.triangles.resize(static_cast<std::size_t>(triangles.size()));
  std::vector<int> next(incidence.first.begin(), incidence.first.end() - 1);
  for (Eigen::Index t = 0; t < triangles.cols(); ++t)
    for (const int v : triangles.col(t))
      incidence.triangles[static_cast<std::size_t>(next[static_cast<std::size_t>(v)]++)] =
          static_cast<int>(t);
  return incidence;
}

/// Vertices from one end of the rest mesh to the other.
std::vector<int> along_the_longer_side(const Points& rest) {
  std::vector<int> vertices(static_cast<std::size_t>(rest.cols()));
  std::iota(vertices.begin(), vertices.end(), 0);
  const Vec2 extent = rest.rowwise().maxCoeff() - rest.rowwise().minCoeff();
  const Eigen::Index side = extent.x() >= extent.y() ? 0 : 1;
  std::ranges::stable_sort(vertices, {}, [&](int v) { return rest(side, v); });
  return vertices;
}

/// Edges between each vertex and the first of its component; components lie over each other.
std::vector<int> depths_of(const Triangles& triangles, const Points& rest) {
  const auto count = static_cast<std::size_t>(rest.cols());
  const Incidence incidence = incidence_of(triangles, count);
  std::vector<int> depths(count, -1), queue;
  for (const int start : along_the_longer_side(rest)) {
    if (depths[static_cast<std::size_t>(start)] >= 0) continue;
    depths[static_cast<std::size_t>(start)] =
        queue.empty() ? 0 : depths[static_cast<std::size_t>(queue.back())] + 1;
    std::size_t next = queue.size();
    for (queue.push_back(start); next < queue.size(); ++next) {
      const auto v = static_cast<std::size_t>(queue[next]);
      for (int i = incidence.first[v]; i < incidence.first[v + 1]; ++i)
        for (const int w : triangles.col(incidence.triangles[static_cast<std::size_t>(i)])) {
          if (depths[static_cast<std::size_t>(w)] >= 0) continue;
          depths[static_cast<std::size_t>(w)] = depths[v] + 1;
          queue.push_back(w);
        }
    }
  }
  return depths;
}

}  // namespace

std::vector<int> drawing_order(const Triangles& triangles, const Points& rest) {
  std::vector<int> order(static_cast<std::size_t>(triangles.cols()));
  std::iota(order.begin(), order.end(), 0);
  if (order.empty()) return order;
  const std::vector<int> depths = depths_of(triangles, rest);
  std::vector<int> keys(order.size(), 0);
  for (std::size_t t = 0; t < keys.size(); ++t)
    for (const int v : triangles.col(static_cast<Eigen::Index>(t)))
      keys[t] += depths[static_cast<std::size_t>(v)];
  std::ranges::stable_sort(order, {}, [&](int t) { return keys[static_cast<std::size_t>(t)]; });
  return order;
}

}  // namespace foldless
