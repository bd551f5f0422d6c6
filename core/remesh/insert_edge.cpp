// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remesh/insert_edge.h"

#include <algorithm>
#include <deque>

#include "core/mesh/orientation.h"

namespace foldless {
namespace {

/// Height over length below which vertices count as collinear.
constexpr double kCollinear = 1e-6;

/// A piece of the segment that passes through no vertex.
struct Piece {
  int end = -1;              ///< the vertex where it ends; −1 where it leaves the domain
  std::deque<int> crossing;  ///< edges, in order
};

int third_corner(const MeshPair& mesh, int t, int p, int q) {
  for (const int v : mesh.triangles().col(t))
    if (v != p && v != q) return v;
  return -1;
}

/// 1 left of the segment from a to b, −1 right of it, 0 nearly on its line.
int side_of(const Points& rest, int a, int b, int v) {
  const double twice = 2 * signed_area(rest.col(a), rest.col(b), rest.col(v));
  const double least = kCollinear * (rest.col(b) - rest.col(a)).squaredNorm();
  return twice > least ? 1 : twice < -least ? -1 : 0;
}

bool is_ahead(const Points& rest, int a, int v, int b) {
  return side_of(rest, a, b, v) == 0 &&
         (rest.col(v) - rest.col(a)).dot(rest.col(b) - rest.col(a)) > 0;
}

void walk(const MeshPair& mesh, int a, int b, int t, int p, int q, Piece& piece) {
  const Points& rest = mesh.rest();
  for (;;) {
    const int e = *mesh.find_edge(p, q);
    if (mesh.is_boundary_edge(e)) return;
    piece.crossing.push_back(e);
    const std::vector<int> beside = mesh.triangles_of_edge(e);
    t = beside[0] == t ? beside[1] : beside[0];
    const int r = third_corner(mesh, t, p, q);
    const int side = side_of(rest, a, b, r);
    if (r == b || side == 0) {
      piece.end = r;
      return;
    }
    (side < 0 ? p : q) = r;
  }
}

/// From a towards b; p is right of the segment, q left.
Piece first_piece(const MeshPair& mesh, int a, int b) {
  const Points& rest = mesh.rest();
  Piece piece;
  for (const int t : mesh.triangles_of_vertex(a)) {
    const Eigen::Vector3i corners = mesh.triangles().col(t);
    const int i = corners[0] == a ? 0 : corners[1] == a ? 1 : 2;
    const int p = corners[(i + 1) % 3], q = corners[(i + 2) % 3];
    for (const int v : {p, q})
      if (v == b || is_ahead(rest, a, v, b)) {
        piece.end = v;
        return piece;
      }
    if (orientation(rest.col(a), rest.col(p), rest.col(b)) > 0 &&
        orientation(rest.col(a), rest.col(q), rest.col(b)) < 0) {
      walk(mesh, a, b, t, p, q, piece);
      return piece;
    }
  }
  return piece;
}

bool is_positive(const Points& rest, int a, int b, int c) {
  const Vec2 p = rest.col(a), q = rest.col(b), r = rest.col(c);
  const double longest =
      std::max({(q - p).squaredNorm(), (r - q).squaredNorm(), (p - r).squaredNorm()});
  return 2 * signed_area(p, q, r) > kCollinear * longest;
}

bool is_convex(const Points& rest, const Diamond& d) {
  return is_positive(rest, d.c, d.d, d.b) && is_positive(rest, d.d, d.c, d.a);
}

bool is_crossed(const Points& rest, int a, int end, int c, int d) {
  if (c == a || c == end || d == a || d == end) return false;
  return side_of(rest, a, end, c) * side_of(rest, a, end, d) < 0;
}

}  // namespace

int insert_edge(MeshPair& mesh, int a, int b) {
  int flips = 0;
  while (a != b) {
    Piece piece = first_piece(mesh, a, b);
    if (piece.end < 0) return flips;
    // Every round of the queue flips at least one edge: some diamond is always convex.
    for (std::size_t idle = 0; !piece.crossing.empty() && idle <= piece.crossing.size();) {
      const int e = piece.crossing.front();
      piece.crossing.pop_front();
      const Diamond diamond = mesh.diamond(e);
      if (!is_convex(mesh.rest(), diamond) || !mesh.is_flip_legal(e)) {
        piece.crossing.push_back(e);
        ++idle;
        continue;
      }
      mesh.flip(e);
      ++flips;
      idle = 0;
      if (is_crossed(mesh.rest(), a, piece.end, diamond.c, diamond.d)) piece.crossing.push_back(e);
    }
    if (!piece.crossing.empty()) return flips;
    a = piece.end;
  }
  return flips;
}

}  // namespace foldless
