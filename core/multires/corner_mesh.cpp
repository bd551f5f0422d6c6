// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/multires/corner_mesh.h"

namespace foldless {

CornerMesh::CornerMesh(const Triangles& triangles, int vertices)
    : from_(triangles.data(), triangles.data() + triangles.size()),
      opposite_(from_.size(), kNone),
      outgoing_(static_cast<std::size_t>(vertices), kNone),
      marked_(static_cast<std::size_t>(vertices), 0) {
  const auto count = static_cast<int>(from_.size());
  // The half-edges of a vertex are next to each other, from start[v] on, in the order of triangles.
  std::vector<int> start(static_cast<std::size_t>(vertices) + 2, 0);
  for (const int v : from_) ++start[static_cast<std::size_t>(v) + 2];
  for (std::size_t v = 2; v < start.size(); ++v) start[v] += start[v - 1];
  std::vector<int> by_vertex(from_.size());
  for (int h = 0; h < count; ++h) {
    outgoing_[static_cast<std::size_t>(from(h))] = h;
    by_vertex[static_cast<std::size_t>(start[static_cast<std::size_t>(from(h)) + 1]++)] = h;
  }
  for (int h = 0; h < count; ++h) {
    const auto end = static_cast<std::size_t>(to(h));
    if (opposite(h) != kNone) continue;
    for (int i = start[end]; i < start[end + 1]; ++i) {
      const int other = by_vertex[static_cast<std::size_t>(i)];
      if (to(other) == from(h)) join(h, other);
    }
  }
}

void CornerMesh::join(int a, int b) {
  if (a != kNone) opposite_[static_cast<std::size_t>(a)] = b;
  if (b != kNone) opposite_[static_cast<std::size_t>(b)] = a;
}

void CornerMesh::leave(int v, int h) {
  if (h != kNone) outgoing_[static_cast<std::size_t>(v)] = h;
}

void CornerMesh::mark_neighbours_of_end(int h) {
  ++mark_;
  // Clockwise from the half-edge that comes after h, and where that ends at the boundary the other
  // way too.
  const int first = next(h);
  int out = first;
  do {
    mark(to(out));
    if (opposite(out) == kNone) break;
    out = clockwise(out);
  } while (out != first);
  if (opposite(out) != kNone) return;
  for (int in = h; in != kNone;) {
    mark(from(in));
    const int across = opposite(in);
    in = across == kNone ? kNone : next(next(across));
  }
}

bool CornerMesh::may_collapse(int h) {
  const int left = to(next(h)), right = to(next(opposite(h)));
  if (left == right) return false;
  mark_neighbours_of_end(h);
  int out = h;
  do {
    const int v = to(out);
    if (marked_[static_cast<std::size_t>(v)] == mark_ && v != left && v != right) return false;
    out = clockwise(out);
  } while (out != h);
  return true;
}

void CornerMesh::collapse(int h) {
  const int gone = from(h), end = to(h), back = opposite(h);
  int out = h;
  do {
    const int following = clockwise(out);
    from_[static_cast<std::size_t>(out)] = end;
    out = following;
  } while (out != h);
  const int left = to(next(h)), right = to(next(back));
  // Beyond the two triangles: a pair of half-edges on either side, of which the first is not of the
  // star of the vertex that goes.
  const int left_outer = opposite(next(h)), left_inner = opposite(next(next(h)));
  const int right_outer = opposite(next(next(back))), right_inner = opposite(next(back));
  join(left_outer, left_inner);
  join(right_outer, right_inner);
  leave(left, left_outer);
  leave(right, right_inner);
  leave(end, right_outer);
  outgoing_[static_cast<std::size_t>(gone)] = kGone;
  for (const int t : {h / 3, back / 3})
    for (int side = 3 * t; side < 3 * t + 3; ++side) from_[static_cast<std::size_t>(side)] = kGone;
}

}  // namespace foldless
