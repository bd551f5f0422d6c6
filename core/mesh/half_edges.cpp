// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/half_edges.h"

#include <array>
#include <cassert>
#include <utility>

namespace foldless {
namespace {

/// The edges that were seen so far, of each vertex those whose other end has a larger number.
class SeenEdges {
 public:
  explicit SeenEdges(int vertices)
      : newest_(static_cast<std::size_t>(vertices), HalfEdges::kNone) {}

  /// The edge's number, or kNone, whereupon it is noted as the next.
  int find_or_add(int a, int b) {
    if (a > b) std::swap(a, b);
    int& newest = newest_[static_cast<std::size_t>(a)];
    for (int e = newest; e != HalfEdges::kNone; e = edges_[static_cast<std::size_t>(e)].before)
      if (edges_[static_cast<std::size_t>(e)].end == b) return e;
    edges_.push_back({b, newest});
    newest = static_cast<int>(edges_.size()) - 1;
    return HalfEdges::kNone;
  }
  void reserve(std::size_t edges) { edges_.reserve(edges); }

 private:
  struct Seen {
    int end;
    int before;  ///< the edge of the same vertex that was noted before
  };
  std::vector<int> newest_;
  std::vector<Seen> edges_;
};

}  // namespace

HalfEdges::HalfEdges(const Triangles& triangles, int vertices)
    : outgoing_(static_cast<std::size_t>(vertices), kNone) {
  const auto faces = static_cast<std::size_t>(triangles.cols());
  const std::size_t edges = outgoing_.size() + faces + 1;  // of a disk, and some
  half_edges_.reserve(2 * edges);
  first_.reserve(faces);
  SeenEdges seen(vertices);
  seen.reserve(edges);
  for (const auto& corners : triangles.colwise()) {
    std::array<int, 3> sides{};
    for (int i = 0; i < 3; ++i) {
      const int a = corners[i], b = corners[(i + 1) % 3];
      const int e = seen.find_or_add(a, b);
      int& h = sides[static_cast<std::size_t>(i)];
      h = e == kNone ? add_edge(a, b) : 2 * e + 1;
      assert(from(h) == a && is_boundary(h));
      outgoing_of(a) = h;
    }
    close(add_triangle(), sides[2], sides[0], sides[1]);
  }
  link_boundary();
}

void HalfEdges::link_boundary() {
  for (int h = 1; h < 2 * edge_count(); h += 2) {  // the even ones have a triangle
    if (!is_boundary(h)) continue;
    outgoing_of(from(h)) = h;
    int after = opposite(h);
    while (!is_boundary(after)) after = opposite(previous(after));
    link(h, after);
  }
}

int HalfEdges::find(int a, int b) const {
  const int begin = outgoing(a);
  if (begin == kNone) return kNone;
  int h = begin;
  do {
    if (to(h) == b) return h;
    h = clockwise(h);
  } while (h != begin);
  return kNone;
}

bool HalfEdges::may_flip(int e) const {
  if (is_boundary_edge(e)) return false;
  const int a = to(next(2 * e)), b = to(next(2 * e + 1));
  return a != b && find(a, b) == kNone;
}

void HalfEdges::flip(int e) {
  const int h = 2 * e, o = opposite(h);
  const int h1 = next(h), h2 = previous(h), o1 = next(o), o2 = previous(o);
  const int end = to(h), begin = to(o), left = triangle(h), right = triangle(o);
  at(h).to = to(h1);
  at(o).to = to(o1);
  close(left, h, h2, o1);
  close(right, o, o2, h1);
  if (outgoing(end) == o) outgoing_of(end) = h1;
  if (outgoing(begin) == h) outgoing_of(begin) = o1;
}

void HalfEdges::split_edge(int e, int v) {
  const int h = 2 * e, o = opposite(h);
  const int begin = to(o);
  const int h1 = next(h), h2 = previous(h), o1 = next(o), o2 = previous(o);
  const int out = add_edge(v, begin), in = opposite(out);  // the half of the edge towards `begin`
  at(o).to = v;
  outgoing_of(v) = h;
  if (is_boundary(h)) {
    link(h2, in);
    link(in, h);
  } else {
    const int across = add_edge(v, to(h1));
    close(triangle(h), h, h1, opposite(across));
    close(add_triangle(), h2, in, across);
  }
  if (is_boundary(o)) {
    link(out, o1);
    link(o, out);
    outgoing_of(v) = out;
  } else {
    const int across = add_edge(v, to(o1));
    close(triangle(o), o, across, o2);
    close(add_triangle(), o1, opposite(across), out);
  }
  if (outgoing(begin) == h) outgoing_of(begin) = in;
}

void HalfEdges::split_triangle(int t, int v) {
  const int a = first(t), b = next(a), c = next(b);
  const int from_a = add_edge(to(a), v), from_b = add_edge(to(b), v), from_c = add_edge(to(c), v);
  close(t, a, from_a, opposite(from_c));
  close(add_triangle(), b, from_b, opposite(from_a));
  close(add_triangle(), c, from_c, opposite(from_b));
  outgoing_of(v) = opposite(from_c);
}

int HalfEdges::add_edge(int from, int to) {
  const auto h = static_cast<int>(half_edges_.size());
  half_edges_.push_back({to, kNone, kNone, kNone});
  half_edges_.push_back({from, kNone, kNone, kNone});
  return h;
}

int HalfEdges::add_triangle() {
  first_.push_back(kNone);
  return triangle_count() - 1;
}

void HalfEdges::link(int before, int after) {
  at(before).next = after;
  at(after).previous = before;
}

void HalfEdges::close(int t, int a, int b, int c) {
  link(a, b);
  link(b, c);
  link(c, a);
  for (const int h : {a, b, c}) at(h).triangle = t;
  first_of(t) = a;
}

}  // namespace foldless
