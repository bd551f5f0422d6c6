// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/engraved.h"

#include <array>
#include <cstddef>
#include <set>
#include <utility>

#include "core/mesh/orientation.h"

namespace foldless {
namespace {

/// What is nearer to an edge or to a vertex than this part of a triangle counts as there.
constexpr double kNearby = 1e-6;

std::size_t number(int index) { return static_cast<std::size_t>(index); }

/// Makes the sides of polygons edges.
class Engraver {
 public:
  explicit Engraver(const MeshPair& mesh)
      : mesh_(mesh), is_on_outline_(number(mesh.vertex_count())) {}

  /// False where the outline was there before.
  bool add_corner(const OutlineCorner& corner) {
    const int v = corner.vertex >= 0 ? corner.vertex : vertex_at(corner.rest);
    corners_.push_back(v);
    return meet(v);
  }

  /// False where the way from the one to the other crosses or touches the outline.
  bool add_side(int corner, int next_corner) {
    const int end = corners_[number(next_corner)];
    for (int v = corners_[number(corner)]; v != end;) {
      const int next = next_on_the_way(v, end);
      const auto distance = [&](int of) {
        return (mesh_.rest().col(of) - mesh_.rest().col(end)).squaredNorm();
      };
      if (next < 0 || distance(next) >= distance(v) || (next != end && !meet(next))) return false;
      outline_.insert({v, next});
      v = next;
    }
    return true;
  }

  /// What is on the left of the sides; nothing where that is on the right of one as well.
  std::optional<MeshPair> part() const {
    const std::vector<bool> is_left = triangles_on_the_left();
    std::vector<int> index(number(mesh_.vertex_count()), -1), vertices = corners_;
    for (std::size_t i = 0; i < corners_.size(); ++i)
      index[number(corners_[i])] = static_cast<int>(i);
    std::vector<int> kept;
    std::vector<bool> is_used(index.size(), false);
    for (int t = 0; t < mesh_.face_count(); ++t) {
      if (!is_left[number(t)]) continue;
      kept.push_back(t);
      for (const int v : mesh_.triangles().col(t)) is_used[number(v)] = true;
    }
    for (int v = 0; v < mesh_.vertex_count(); ++v) {
      if (!is_used[number(v)] || index[number(v)] >= 0) continue;
      index[number(v)] = static_cast<int>(vertices.size());
      vertices.push_back(v);
    }
    for (const auto& [from, to] : outline_)
      if (const int right = triangle_left_of(to, from); right >= 0 && is_left[number(right)])
        return std::nullopt;
    Triangles triangles = mesh_.triangles()(Eigen::all, kept);
    for (int& v : triangles.reshaped()) v = index[number(v)];
    return MeshPair(triangles, mesh_.rest()(Eigen::all, vertices),
                    mesh_.deformed()(Eigen::all, vertices));
  }

 private:
  /// False where it is on the outline already.
  bool meet(int v) {
    is_on_outline_.resize(number(mesh_.vertex_count()), false);
    if (is_on_outline_[number(v)]) return false;
    return is_on_outline_[number(v)] = true;
  }

  /// One that is there, or a new one.
  int vertex_at(const Vec2& p) {
    int triangle = 0;
    Eigen::Vector3d place = barycentric_of(mesh_.rest(), mesh_.triangles().col(0), p);
    for (int t = 1; t < mesh_.face_count(); ++t) {
      const Eigen::Vector3d in_t = barycentric_of(mesh_.rest(), mesh_.triangles().col(t), p);
      if (in_t.minCoeff() <= place.minCoeff()) continue;
      triangle = t;
      place = in_t;
    }
    const int v = split(triangle, place);
    mesh_.move_vertex(v, p, mesh_.deformed().col(v));  // from nearby, or from where rounding put it
    return v;
  }

  int split(int triangle, const Eigen::Vector3d& place) {
    const Eigen::Vector3i corners = mesh_.triangles().col(triangle);
    Eigen::Index nearest = 0, opposite = 0;
    if (place.maxCoeff(&nearest) > 1 - kNearby) return corners[nearest];
    if (place.minCoeff(&opposite) >= kNearby) return mesh_.split_triangle(triangle, place);
    const Eigen::Index from = (opposite + 1) % 3, to = (opposite + 2) % 3;
    return split_edge(corners[from], corners[to], place[to] / (place[from] + place[to]));
  }

  int split_edge(int from, int to, double t) {
    const int e = *mesh_.find_edge(from, to);
    return mesh_.split_edge(e, mesh_.edge(e)[0] == from ? t : 1 - t);
  }

  /// The end of the first piece of the way from a to b; −1 where it would cross the outline.
  int next_on_the_way(int a, int b) {
    const Points& rest = mesh_.rest();
    std::vector<std::array<int, 2>> opposite;  // sides of the triangles at a
    for (const int t : mesh_.triangles_of_vertex(a)) {
      const Eigen::Vector3i corners = mesh_.triangles().col(t);
      const int i = corners[0] == a ? 0 : corners[1] == a ? 1 : 2;
      opposite.push_back({corners[(i + 1) % 3], corners[(i + 2) % 3]});
      if (opposite.back()[0] == b || opposite.back()[1] == b) return b;
    }
    for (const auto& [p, q] : opposite)
      if (orientation(rest.col(a), rest.col(p), rest.col(b)) >= 0 &&
          orientation(rest.col(a), rest.col(q), rest.col(b)) <= 0)
        return crossing_on(a, b, p, q);
    return -1;
  }

  /// Where the way from a to b crosses the edge from p, which is right of it, to q.
  int crossing_on(int a, int b, int p, int q) {
    const Points& rest = mesh_.rest();
    const double right = -signed_area(rest.col(a), rest.col(b), rest.col(p)),
                 left = signed_area(rest.col(a), rest.col(b), rest.col(q));
    const double t = right / (right + left);
    if (t < kNearby) return p;
    if (t > 1 - kNearby) return q;
    if (is_outline(p, q)) return -1;
    return split_edge(p, q, t);
  }

  bool is_outline(int a, int b) const {
    return outline_.contains({a, b}) || outline_.contains({b, a});
  }

  /// −1: none.
  int triangle_left_of(int from, int to) const {
    for (const int t : mesh_.triangles_of_edge(*mesh_.find_edge(from, to))) {
      const Eigen::Vector3i corners = mesh_.triangles().col(t);
      for (int i = 0; i < 3; ++i)
        if (corners[i] == from && corners[(i + 1) % 3] == to) return t;
    }
    return -1;
  }

  std::vector<bool> triangles_on_the_left() const {
    std::vector<bool> is_left(number(mesh_.face_count()), false);
    std::vector<int> stack;
    const auto reach = [&](int t) {
      if (t < 0 || is_left[number(t)]) return;
      is_left[number(t)] = true;
      stack.push_back(t);
    };
    for (const auto& [from, to] : outline_) reach(triangle_left_of(from, to));
    while (!stack.empty()) {
      const Eigen::Vector3i corners = mesh_.triangles().col(stack.back());
      stack.pop_back();
      for (int i = 0; i < 3; ++i) {
        const int from = corners[i], to = corners[(i + 1) % 3];
        if (!is_outline(from, to)) reach(triangle_left_of(to, from));
      }
    }
    return is_left;
  }

  MeshPair mesh_;
  std::vector<int> corners_;              ///< vertices
  std::vector<bool> is_on_outline_;       ///< by vertex
  std::set<std::array<int, 2>> outline_;  ///< from vertex to vertex
};

}  // namespace

std::optional<MeshPair> engraved(const MeshPair& mesh,
                                 const std::vector<std::vector<OutlineCorner>>& loops) {
  Engraver engraver(mesh);
  for (const std::vector<OutlineCorner>& loop : loops)
    for (const OutlineCorner& corner : loop)
      if (!engraver.add_corner(corner)) return std::nullopt;
  int first = 0;
  for (const std::vector<OutlineCorner>& loop : loops) {
    const int count = static_cast<int>(loop.size());
    for (int i = 0; i < count; ++i)
      if (!engraver.add_side(first + i, first + (i + 1) % count)) return std::nullopt;
    first += count;
  }
  return engraver.part();
}

}  // namespace foldless
