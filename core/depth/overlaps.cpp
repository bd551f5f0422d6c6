// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/depth/overlaps.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <tuple>
#include <unordered_set>
#include <utility>

#include "core/depth/box_grid.h"

namespace foldless {
namespace {

/// Penetration this small, of the size of the triangles, is rounding.
constexpr double kTouching = 1e-9;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

bool have_common_corner(const Triangles& triangles, const Overlap& pair) {
  for (const int v : triangles.col(pair.a))
    if ((triangles.col(pair.b).array() == v).any()) return true;
  return false;
}

enum class Meeting { apart, contact, overlap };

/// How the second triangle lies to the edges of the first.
Meeting meeting_at_edges(const Triangles& triangles, const Points& points, int a, int b) {
  Meeting meeting = Meeting::overlap;
  for (int k = 0; k < 3; ++k) {
    const Vec2 start = points.col(triangles(k, a));
    const Vec2 along = points.col(triangles((k + 1) % 3, a)) - start;
    double inwards = -std::numeric_limits<double>::infinity(), reach = 0;
    for (const int v : triangles.col(b)) {
      const Vec2 way = points.col(v) - start;
      inwards = std::max(inwards, cross(along, way));
      reach = std::max(reach, way.lpNorm<1>());
    }
    const double rounding = kTouching * along.lpNorm<1>() * reach;
    if (inwards < -rounding) return Meeting::apart;
    if (inwards <= rounding) meeting = Meeting::contact;
  }
  return meeting;
}

/// The pairs that were met, each once.
class Walk {
 public:
  Walk(const Triangles& triangles, const Points& points, CommonCorners corners)
      : triangles_(triangles), points_(points), corners_(corners) {}

  /// Keeps the pair if it is new and its triangles meet.
  void meet(int a, int b) {
    if (a < 0 || b < 0 || a == b) return;
    Overlap pair{std::min(a, b), std::max(a, b)};
    const std::uint64_t key =
        (static_cast<std::uint64_t>(pair.a) << 32) | static_cast<std::uint64_t>(pair.b);
    if (met_.contains(key)) return;
    const bool are_neighbours = have_common_corner(triangles_, pair);
    if (are_neighbours && corners_ == CommonCorners::apart) return;
    const Meeting meeting = std::min(meeting_at_edges(triangles_, points_, pair.a, pair.b),
                                     meeting_at_edges(triangles_, points_, pair.b, pair.a));
    if (meeting == Meeting::apart || (meeting == Meeting::contact && are_neighbours)) return;
    pair.is_contact = meeting == Meeting::contact;
    met_.insert(key);
    pairs.push_back(pair);
  }

  std::vector<Overlap> pairs;

 private:
  const Triangles& triangles_;
  const Points& points_;
  CommonCorners corners_;
  std::unordered_set<std::uint64_t> met_;
};

}  // namespace

OverlapSearch::OverlapSearch(const Triangles& triangles, int vertex_count)
    : triangles_(triangles), first_(at(vertex_count) + 1, 0) {
  for (const int v : triangles.reshaped()) ++first_[at(v) + 1];
  for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
  sides_.resize(static_cast<std::size_t>(triangles.size()));
  std::vector<int> next(first_.begin(), first_.end() - 1);
  for (int t = 0; t < static_cast<int>(triangles.cols()); ++t)
    for (int k = 0; k < 3; ++k)
      sides_[at(next[at(triangles(k, t))]++)] = {triangles((k + 1) % 3, t), t};
  for (int v = 0; v < vertex_count; ++v)
    for (int i = first_[at(v)]; i < first_[at(v) + 1]; ++i)
      if (triangle_of_side(sides_[at(i)].to, v) < 0)
        boundary_.push_back({v, sides_[at(i)].to, sides_[at(i)].triangle});
}

/// −1 where there is none.
int OverlapSearch::triangle_of_side(int from, int to) const {
  for (int i = first_[at(from)]; i < first_[at(from) + 1]; ++i)
    if (sides_[at(i)].to == to) return sides_[at(i)].triangle;
  return -1;
}

std::array<int, 3> OverlapSearch::neighbours(int triangle) const {
  const Eigen::Vector3i t = triangles_.col(triangle);
  return {triangle_of_side(t[1], t[0]), triangle_of_side(t[2], t[1]), triangle_of_side(t[0], t[2])};
}

/// Pairs of a triangle at the boundary and one that the box of its boundary edge touches.
std::vector<Overlap> OverlapSearch::at_boundary(const Points& points) const {
  std::vector<Eigen::AlignedBox2d> boxes(boundary_.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    boxes[i].extend(points.col(boundary_[i].from));
    boxes[i].extend(points.col(boundary_[i].to));
  }
  const BoxGrid grid(boxes);
  std::vector<Overlap> pairs;
  for (int t = 0; t < static_cast<int>(triangles_.cols()); ++t) {
    Eigen::AlignedBox2d box;
    for (const int v : triangles_.col(t)) box.extend(points.col(v));
    grid.for_each_near(box, [&](int edge) { pairs.push_back({boundary_[at(edge)].triangle, t}); });
  }
  return pairs;
}

std::vector<Overlap> OverlapSearch::find(const Points& points, CommonCorners corners) const {
  if (triangles_.cols() == 0) return {};
  Walk walk(triangles_, points, corners);
  for (const Overlap& pair : at_boundary(points)) walk.meet(pair.a, pair.b);
  for (std::size_t i = 0; i < walk.pairs.size(); ++i) {
    const auto [a, b, is_contact] = walk.pairs[i];
    for (const int next : neighbours(a)) walk.meet(next, b);
    for (const int next : neighbours(b)) walk.meet(a, next);
  }
  std::ranges::sort(walk.pairs, {}, [](const Overlap& o) { return std::tuple(o.a, o.b); });
  return std::move(walk.pairs);
}

}  // namespace foldless
