// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/multires/insert_edge.h"

#include <deque>

#include "core/mesh/orientation.h"
#include "core/remesh/diamond_energy.h"

namespace foldless {
namespace {

/// Looks at an edge in the queue, over the square of their number. Random meshes took 1.
constexpr std::size_t kMostLooks = 4;

/// From vertex a of the rest mesh to vertex b.
struct Segment {
  const Points& rest;
  int a, b;

  /// 1 left of the segment, −1 right of it, 0 nearly on its line.
  int side_of(int v) const {
    const double twice = 2 * signed_area(rest.col(a), rest.col(b), rest.col(v));
    const double least = kLeastRelativeHeight * (rest.col(b) - rest.col(a)).squaredNorm();
    return twice > least ? 1 : twice < -least ? -1 : 0;
  }
  bool has_ahead(int v) const {
    return side_of(v) == 0 && (rest.col(v) - rest.col(a)).dot(rest.col(b) - rest.col(a)) > 0;
  }
  bool crosses(int c, int d) const {
    if (c == a || c == b || d == a || d == b) return false;
    return side_of(c) * side_of(d) < 0;
  }
};

/// A piece of the segment that passes through no vertex.
struct Piece {
  int end = -1;              ///< the vertex where it ends; −1 where it leaves the domain
  std::deque<int> crossing;  ///< edges, in order
};

/// Where a segment leaves a triangle: p is right of the segment, q left.
struct Exit {
  int triangle, p, q;
};

int third_corner(const MeshPair& mesh, const Exit& exit) {
  for (const int v : mesh.triangles().col(exit.triangle))
    if (v != exit.p && v != exit.q) return v;
  return -1;
}

Piece walk(const MeshPair& mesh, const Segment& segment, Exit exit) {
  Piece piece;
  for (;;) {
    const int e = *mesh.find_edge(exit.p, exit.q);
    if (mesh.is_boundary_edge(e)) return piece;
    piece.crossing.push_back(e);
    const std::vector<int> beside = mesh.triangles_of_edge(e);
    exit.triangle = beside[0] == exit.triangle ? beside[1] : beside[0];
    const int r = third_corner(mesh, exit);
    const int side = segment.side_of(r);
    if (r == segment.b || side == 0) {
      piece.end = r;
      return piece;
    }
    (side < 0 ? exit.p : exit.q) = r;
  }
}

/// From a towards b.
Piece first_piece(const MeshPair& mesh, int a, int b) {
  const Points& rest = mesh.rest();
  const Segment segment{rest, a, b};
  for (const int t : mesh.triangles_of_vertex(a)) {
    const Eigen::Vector3i corners = mesh.triangles().col(t);
    const int i = corners[0] == a ? 0 : corners[1] == a ? 1 : 2;
    const int p = corners[(i + 1) % 3], q = corners[(i + 2) % 3];
    for (const int v : {p, q})
      if (v == b || segment.has_ahead(v)) return {.end = v, .crossing = {}};
    if (orientation(rest.col(a), rest.col(p), rest.col(b)) > 0 &&
        orientation(rest.col(a), rest.col(q), rest.col(b)) < 0)
      return walk(mesh, segment, {t, p, q});
  }
  return {};
}

/// Flips until nothing crosses the piece that begins at a, or nothing is gained; returns how often.
int clear(MeshPair& mesh, int a, Piece& piece) {
  std::deque<int>& queue = piece.crossing;
  const Segment segment{mesh.rest(), a, piece.end};
  int flips = 0;
  for (std::size_t looks = kMostLooks * queue.size() * queue.size(); looks > 0; --looks) {
    if (queue.empty()) break;
    const int e = queue.front();
    queue.pop_front();
    const Diamond diamond = mesh.diamond(e);
    const bool flips_now =
        mesh.is_flip_legal(e) && is_positive_at_rest(mesh, flipped_triangles_of(diamond));
    if (flips_now) {
      mesh.flip(e);
      ++flips;
    }
    if (!flips_now || segment.crosses(diamond.c, diamond.d)) queue.push_back(e);
  }
  return flips;
}

}  // namespace

int insert_edge(MeshPair& mesh, int a, int b) {
  const auto distance = [&](int v) { return (mesh.rest().col(v) - mesh.rest().col(b)).norm(); };
  int flips = 0;
  while (a != b) {
    Piece piece = first_piece(mesh, a, b);
    // Where the domain lies over itself a piece may lead to another sheet, past b.
    if (piece.end < 0 || distance(piece.end) >= distance(a)) break;
    flips += clear(mesh, a, piece);
    if (!piece.crossing.empty()) break;
    a = piece.end;
  }
  return flips;
}

}  // namespace foldless
