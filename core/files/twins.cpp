// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/twins.h"

#include <algorithm>
#include <cstddef>
#include <span>

namespace foldless {
namespace {

/// A halfedge in the bucket of the smaller of its ends.
struct Spoke {
  int other;  ///< the larger end
  int halfedge;
  bool forward;  ///< goes from the smaller to the larger end
};

int next(int halfedge) { return halfedge % 3 == 2 ? halfedge - 2 : halfedge + 1; }
int previous(int halfedge) { return halfedge % 3 == 0 ? halfedge + 2 : halfedge - 1; }
int start(const Triangles& triangles, int halfedge) {
  return triangles(halfedge % 3, halfedge / 3);
}

void keep_smaller(std::optional<int>& first, int candidate) {
  if (!first || candidate < *first) first = candidate;
}

/// Notes the spokes of one edge, in order of their halfedges.
void pair_edge(std::span<const Spoke> spokes, Twins& twins) {
  const int first = spokes[0].halfedge;
  if (spokes.size() > 2) {
    ++twins.crowded_edges;
    keep_smaller(twins.first_crowded, first);
    if (twins.first_crowded == first)
      twins.first_crowded_triangles = static_cast<int>(spokes.size());
  } else if (spokes.size() == 2 && spokes[0].forward == spokes[1].forward) {
    ++twins.same_side_edges;
    keep_smaller(twins.first_same_side, first);
  } else if (spokes.size() == 2) {
    twins.twin[static_cast<std::size_t>(first)] = spokes[1].halfedge;
    twins.twin[static_cast<std::size_t>(spokes[1].halfedge)] = first;
  }
}

void pair_bucket(std::span<Spoke> bucket, Twins& twins) {
  std::ranges::sort(bucket, [](const Spoke& a, const Spoke& b) {
    return a.other != b.other ? a.other < b.other : a.halfedge < b.halfedge;
  });
  for (std::size_t i = 0, j = 0; i < bucket.size(); i = j) {
    while (j < bucket.size() && bucket[j].other == bucket[i].other) ++j;
    pair_edge(bucket.subspan(i, j - i), twins);
  }
}

}  // namespace

Eigen::Vector2i halfedge_ends(const Triangles& triangles, int halfedge) {
  return {start(triangles, halfedge), start(triangles, next(halfedge))};
}

Twins find_twins(const Triangles& triangles, int vertex_count) {
  // A counting sort by the smaller end; the buckets are small.
  const int halfedges = static_cast<int>(3 * triangles.cols());
  std::vector<std::size_t> begin(static_cast<std::size_t>(vertex_count) + 2, 0);
  const auto bucket_of = [&](int h) {
    return static_cast<std::size_t>(halfedge_ends(triangles, h).minCoeff());
  };
  for (int h = 0; h < halfedges; ++h) ++begin[bucket_of(h) + 2];
  for (std::size_t v = 2; v < begin.size(); ++v) begin[v] += begin[v - 1];
  std::vector<Spoke> spokes(static_cast<std::size_t>(halfedges));
  for (int h = 0; h < halfedges; ++h) {
    const Eigen::Vector2i ends = halfedge_ends(triangles, h);
    spokes[begin[bucket_of(h) + 1]++] = {ends.maxCoeff(), h, ends[0] < ends[1]};
  }

  Twins twins;
  twins.twin.assign(spokes.size(), -1);
  for (std::size_t v = 0; v + 1 < begin.size(); ++v)
    pair_bucket(std::span(spokes).subspan(begin[v], begin[v + 1] - begin[v]), twins);
  return twins;
}

std::vector<int> bow_tie_vertices(const Triangles& triangles, const Twins& twins,
                                  int vertex_count) {
  const int halfedges = static_cast<int>(3 * triangles.cols());
  std::vector<int> corners(static_cast<std::size_t>(vertex_count), 0);
  std::vector<int> outgoing(static_cast<std::size_t>(vertex_count), -1);
  for (int h = 0; h < halfedges; ++h) {
    const auto v = static_cast<std::size_t>(start(triangles, h));
    ++corners[v];
    // A fan is walked counter-clockwise, so it begins at the edge that nothing lies to the right
    // of.
    if (outgoing[v] < 0 || twins.twin[static_cast<std::size_t>(h)] < 0) outgoing[v] = h;
  }
  std::vector<int> bow_ties;
  for (std::size_t v = 0; v < corners.size(); ++v) {
    if (outgoing[v] < 0) continue;
    int visited = 0;
    int h = outgoing[v];
    do {
      ++visited;
      h = twins.twin[static_cast<std::size_t>(previous(h))];
    } while (h >= 0 && h != outgoing[v]);
    if (visited < corners[v]) bow_ties.push_back(static_cast<int>(v));
  }
  return bow_ties;
}

}  // namespace foldless
