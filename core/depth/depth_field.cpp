// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/depth/depth_field.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "core/mesh/components.h"

namespace foldless {
namespace {

using Weights = Eigen::SparseMatrix<double>;
using Entry = Eigen::Triplet<double>;

/// Weights of edges are kept within these: the cotangents of good triangles are about 1.
constexpr double kLeast = 1e-6, kMost = 1e6;

double cotangent(const Vec2& at, const Vec2& a, const Vec2& b) {
  return (a - at).dot(b - at) / std::abs(cross(a - at, b - at));
}

/// Weight of the edge between two vertices: half the sum of the cotangents that face it.
Weights edge_weights(const Triangles& triangles, const Points& rest) {
  std::vector<Entry> entries;
  entries.reserve(static_cast<std::size_t>(2 * triangles.size()));
  for (const auto& t : triangles.colwise())
    for (int k = 0; k < 3; ++k) {
      const int a = t[(k + 1) % 3], b = t[(k + 2) % 3];
      const double weight = 0.5 * cotangent(rest.col(t[k]), rest.col(a), rest.col(b));
      entries.emplace_back(a, b, weight);
      entries.emplace_back(b, a, weight);
    }
  Weights weights(rest.cols(), rest.cols());
  weights.setFromTriplets(entries.begin(), entries.end());
  for (Eigen::Index i = 0; i < weights.nonZeros(); ++i) {
    double& weight = weights.valuePtr()[i];
    weight = weight > kLeast ? std::min(weight, kMost) : kLeast;
  }
  return weights;
}

/// Row of every vertex in the system, −1 for those whose value is known.
Eigen::VectorXi rows_of(const Triangles& triangles, int vertices,
                        const std::vector<Handle>& handles) {
  const std::vector<int> component = components_of(triangles, vertices);
  const auto at = [](int v) { return static_cast<std::size_t>(v); };
  std::vector<bool> is_free(at(vertices), false);
  for (const Handle& handle : handles) is_free[at(component[at(handle.vertex)])] = true;
  Eigen::VectorXi rows = Eigen::VectorXi::Constant(vertices, -1);
  for (const int v : triangles.reshaped())
    if (is_free[at(component[at(v)])]) rows[v] = 0;
  for (const Handle& handle : handles) rows[handle.vertex] = -1;
  int next = 0;
  for (int& row : rows)
    if (row >= 0) row = next++;
  return rows;
}

}  // namespace

bool has_depths(const std::vector<Handle>& handles) {
  return std::ranges::any_of(handles, [](const Handle& handle) { return handle.depth != 0; });
}

Eigen::VectorXd depth_field(const Triangles& triangles, const Points& rest,
                            const std::vector<Handle>& handles) {
  Eigen::VectorXd depth = Eigen::VectorXd::Zero(rest.cols());
  if (!has_depths(handles)) return depth;
  for (const Handle& handle : handles) depth[handle.vertex] = handle.depth;
  const Eigen::VectorXi rows = rows_of(triangles, static_cast<int>(rest.cols()), handles);
  const int count = rows.maxCoeff() + 1;
  if (count == 0) return depth;
  const Weights weights = edge_weights(triangles, rest);
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(count), known = Eigen::VectorXd::Zero(count);
  std::vector<Entry> entries;
  for (int v = 0; v < rows.size(); ++v) {
    if (rows[v] < 0) continue;
    for (Weights::InnerIterator edge(weights, v); edge; ++edge) {
      const int other = static_cast<int>(edge.row());
      diagonal[rows[v]] += edge.value();
      if (rows[other] < 0) known[rows[v]] += edge.value() * depth[other];
      if (rows[other] > rows[v]) entries.emplace_back(rows[other], rows[v], -edge.value());
    }
  }
  for (int i = 0; i < count; ++i) entries.emplace_back(i, i, diagonal[i]);
  Weights system(count, count);
  system.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd values = Eigen::SimplicialLDLT<Weights>(system).solve(known);
  for (int v = 0; v < rows.size(); ++v)
    if (rows[v] >= 0) depth[v] = values[rows[v]];
  return depth;
}

bool DepthField::holds(const Points& rest, const std::vector<Handle>& handles) const {
  const auto is_same = [](const Handle& a, const Handle& b) {
    return a.vertex == b.vertex && a.depth == b.depth;
  };
  return rest_.cols() > 0 && rest.cols() >= rest_.cols() && rest.leftCols(rest_.cols()) == rest_ &&
         std::ranges::equal(handles, handles_, is_same);
}

/// Later vertices were made of earlier ones; false where one has no earlier neighbour any more.
bool DepthField::extend(const Triangles& triangles, Eigen::Index count) {
  const Eigen::Index first = depth_.size();
  std::vector<std::vector<int>> earlier(static_cast<std::size_t>(count - first));
  for (const auto& t : triangles.colwise())
    for (const int v : t)
      for (const int other : t)
        if (v >= first && other < v) earlier[static_cast<std::size_t>(v - first)].push_back(other);
  depth_.conservativeResize(count);
  for (std::size_t i = 0; i < earlier.size(); ++i) {
    if (earlier[i].empty()) return false;
    depth_[first + static_cast<Eigen::Index>(i)] = depth_(earlier[i]).mean();
  }
  return true;
}

const Eigen::VectorXd& DepthField::update(const Triangles& triangles, const Points& rest,
                                          const std::vector<Handle>& handles) {
  if (!holds(rest, handles) || !extend(triangles, rest.cols()))
    depth_ = depth_field(triangles, rest, handles);
  handles_ = handles;
  rest_ = rest;
  return depth_;
}

}  // namespace foldless
