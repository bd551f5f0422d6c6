// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/growing_mesh.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/mesh/orientation.h"

namespace foldless {
namespace {

/// See shape(): where a frame takes a thinner triangle would be a matter of rounding.
constexpr double kLeastShape = 1e-6;

Edge edge_of(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

}  // namespace

GrowingMesh::GrowingMesh(const Triangles& triangles, const Points& rest)
    : origins_(static_cast<std::size_t>(triangles.cols())) {
  std::iota(origins_.begin(), origins_.end(), 0);
  for (const auto& p : rest.colwise()) rest_.emplace_back(p);
  for (const auto& t : triangles.colwise()) triangles_.emplace_back(t);
  for (int t = 0; t < face_count(); ++t) enter(t);
}

void GrowingMesh::enter(int t) {
  const Eigen::Vector3i& c = triangle(t);
  for (int k = 0; k < 3; ++k) beside_[edge_of(c[k], c[(k + 1) % 3])].push_back(t);
}

void GrowingMesh::leave(int t) {
  const Eigen::Vector3i& c = triangle(t);
  for (int k = 0; k < 3; ++k) std::erase(beside_[edge_of(c[k], c[(k + 1) % 3])], t);
}

std::vector<int> GrowingMesh::beside(int a, int b) const {
  const auto place = beside_.find(edge_of(a, b));
  return place == beside_.end() ? std::vector<int>() : place->second;
}

std::vector<int> GrowingMesh::split_edge(int a, int b, const Vec2& at) {
  const int v = vertex_count();
  std::vector<Replacement> replacements;
  for (const int t : beside(a, b)) {
    Eigen::Vector3i with_a = triangle(t), with_b = with_a;
    for (int k = 0; k < 3; ++k) {
      if (with_b[k] == a) with_b[k] = v;
      if (with_a[k] == b) with_a[k] = v;
    }
    replacements.push_back({t, {with_a, with_b}});
  }
  return replace(replacements, at);
}

std::vector<int> GrowingMesh::flip_edge(int a, int b) {
  std::vector<int> pair = beside(a, b);
  if (pair.size() != 2 || origin(pair[0]) != origin(pair[1])) return {};
  // The first triangle has the edge from a to b, the second back.
  const Eigen::Vector3i first = triangle(pair[0]), second = triangle(pair[1]);
  for (int k = 0; k < 3; ++k)
    if (first[k] == b && first[(k + 1) % 3] == a) std::swap(a, b);
  const int c = first.sum() - a - b, d = second.sum() - a - b;
  const double before = std::min(shape(first), shape(second));
  const auto is_better = [&](const Eigen::Vector3i& t) {
    return orientation(rest(t[0]), rest(t[1]), rest(t[2])) > 0 && shape(t) > before;
  };
  const Eigen::Vector3i at_a{c, a, d}, at_b{d, b, c};
  if (!is_better(at_a) || !is_better(at_b)) return {};
  for (const int t : pair) leave(t);
  triangles_[static_cast<std::size_t>(pair[0])] = at_a;
  triangles_[static_cast<std::size_t>(pair[1])] = at_b;
  for (const int t : pair) enter(t);
  return pair;
}

double GrowingMesh::shape(const Eigen::Vector3i& t) const {
  const Vec2 a = rest(t[0]), b = rest(t[1]), c = rest(t[2]);
  return signed_area(a, b, c) /
         std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
}

std::vector<int> GrowingMesh::split_triangle(int t, const Vec2& at) {
  const int v = vertex_count();
  const Eigen::Vector3i c = triangle(t);
  return replace({{t, {{c[0], c[1], v}, {c[1], c[2], v}, {c[2], c[0], v}}}}, at);
}

std::vector<int> GrowingMesh::replace(const std::vector<Replacement>& replacements,
                                      const Vec2& at) {
  rest_.push_back(at);
  const auto is_good = [&](const Eigen::Vector3i& t) {
    return orientation(rest(t[0]), rest(t[1]), rest(t[2])) > 0 && shape(t) >= kLeastShape;
  };
  for (const Replacement& replacement : replacements)
    if (!std::ranges::all_of(replacement.parts, is_good)) {
      rest_.pop_back();
      return {};
    }
  std::vector<int> changed;
  for (const auto& [t, parts] : replacements) {
    leave(t);
    triangles_[static_cast<std::size_t>(t)] = parts.front();
    enter(t);
    changed.push_back(t);
    for (std::size_t i = 1; i < parts.size(); ++i) {
      triangles_.push_back(parts[i]);
      origins_.push_back(origin(t));
      enter(face_count() - 1);
      changed.push_back(face_count() - 1);
    }
  }
  return changed;
}

Triangles GrowingMesh::triangles() const {
  Triangles result(3, face_count());
  for (int t = 0; t < face_count(); ++t) result.col(t) = triangle(t);
  return result;
}

Points GrowingMesh::rest() const {
  Points result(2, vertex_count());
  for (int v = 0; v < vertex_count(); ++v) result.col(v) = rest(v);
  return result;
}

}  // namespace foldless
