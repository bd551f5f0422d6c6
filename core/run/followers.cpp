// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/followers.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "core/mesh/orientation.h"

namespace foldless {
namespace {

/// Who is next to whom: the vertices that share a triangle with one.
class Neighbours {
 public:
  explicit Neighbours(const Triangles& triangles) {
    const int vertices = triangles.cols() > 0 ? triangles.maxCoeff() + 1 : 0;
    start_.assign(static_cast<std::size_t>(vertices) + 1, 0);
    for (const int v : triangles.reshaped()) start_[static_cast<std::size_t>(v) + 1] += 2;
    for (std::size_t v = 1; v < start_.size(); ++v) start_[v] += start_[v - 1];
    neighbours_.resize(static_cast<std::size_t>(start_.back()));
    std::vector<int> next = start_;
    for (const auto& triangle : triangles.colwise())
      for (int i = 0; i < 3; ++i)
        for (int j = 1; j < 3; ++j)
          neighbours_[static_cast<std::size_t>(next[static_cast<std::size_t>(triangle[i])]++)] =
              triangle[(i + j) % 3];
  }

  /// One more than the largest index of a vertex.
  int vertex_count() const { return static_cast<int>(start_.size()) - 1; }

  template <class Visit>
  void visit(int vertex, const Visit& visit) const {
    const auto v = static_cast<std::size_t>(vertex);
    for (int k = start_[v]; k < start_[v + 1]; ++k) visit(neighbours_[static_cast<std::size_t>(k)]);
  }

 private:
  std::vector<int> start_, neighbours_;
};

/// Where a walk from a handle begins: at its vertex, or at the corners of the original triangle in
/// which a split made it.
std::vector<int> beginning(const Triangles& original, const Points& rest, int vertex,
                           int original_vertices) {
  if (vertex < original_vertices) return {vertex};
  const Vec2 p = rest.col(vertex);
  for (const auto& t : original.colwise()) {
    const auto is_left = [&](int a, int b) {
      return signed_area(rest.col(t[a]), rest.col(t[b]), p) >= 0;
    };
    if (is_left(0, 1) && is_left(1, 2) && is_left(2, 0)) return {t[0], t[1], t[2]};
  }
  return {};
}

/// Original vertices within the radius of a handle, as far as edges lead to them there.
std::vector<int> vertices_near(const Triangles& original, const Points& rest,
                               const Neighbours& neighbours, const Handle& handle) {
  const int original_vertices = neighbours.vertex_count();
  const Vec2 centre = rest.col(handle.vertex);
  std::vector<bool> is_seen(static_cast<std::size_t>(original_vertices), false);
  std::vector<int> found;
  const auto offer = [&](int v) {
    if (is_seen[static_cast<std::size_t>(v)]) return;
    is_seen[static_cast<std::size_t>(v)] = true;
    if ((rest.col(v) - centre).norm() <= handle.turn->radius) found.push_back(v);
  };
  for (const int v : beginning(original, rest, handle.vertex, original_vertices)) offer(v);
  for (std::size_t i = 0; i < found.size(); ++i) neighbours.visit(found[i], offer);
  return found;
}

}  // namespace

Followers::Followers(const Triangles& original, const Points& rest,
                     const std::vector<Handle>& handles) {
  if (std::ranges::none_of(handles, [](const Handle& handle) { return handle.turn.has_value(); }))
    return;
  const Neighbours neighbours(original);
  std::map<int, Follower> by_vertex;
  for (std::size_t i = 0; i < handles.size(); ++i) {
    if (!handles[i].turn) continue;
    for (const int v : vertices_near(original, rest, neighbours, handles[i])) {
      const Follower follower{v, i, rest.col(v) - rest.col(handles[i].vertex)};
      const auto [place, is_new] = by_vertex.try_emplace(v, follower);
      if (!is_new && follower.offset.norm() < place->second.offset.norm()) place->second = follower;
    }
  }
  for (const Handle& handle : handles) by_vertex.erase(handle.vertex);
  for (const auto& [vertex, follower] : by_vertex) followers_.push_back(follower);
}

std::vector<Handle> Followers::with_followers(const std::vector<Handle>& handles) const {
  std::vector<Handle> all = handles;
  for (const Follower& follower : followers_) {
    Handle handle = handles[follower.leader];
    const double angle = handle.turn->angle * std::numbers::pi / 180;
    handle.vertex = follower.vertex;
    handle.target += Eigen::Rotation2Dd(angle) * follower.offset;
    all.push_back(std::move(handle));
  }
  return all;
}

}  // namespace foldless
