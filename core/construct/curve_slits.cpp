// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/curve_slits.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "core/construct/curve_energy.h"
#include "core/construct/directed_edge.h"

namespace foldless {
namespace {

/// A curve that is cut.
struct CurveSlit {
  const CarriedCurves::Curve* curve;
  int first_bend;  ///< its vertex
};

/// By directed edge.
using CurveSlits = std::unordered_map<std::uint64_t, CurveSlit>;

/// The shortest forest [Kru56] with all of the outline in one tree.
CurveSlits shortest_slits(const std::vector<CarriedCurves::Curve>& curves,
                          const TriangulatedDisk& disk) {
  std::vector<std::pair<double, const CarriedCurves::Curve*>> by_length;
  by_length.reserve(curves.size());
  for (const CarriedCurves::Curve& curve : curves)
    by_length.emplace_back((disk.rest.col(curve.to) - disk.rest.col(curve.from)).norm() +
                               length_of(curve, disk.deformed),
                           &curve);
  std::ranges::stable_sort(by_length, {}, &std::pair<double, const CarriedCurves::Curve*>::first);
  std::vector<int> trees(static_cast<std::size_t>(disk.rest.cols()));
  std::iota(trees.begin(), trees.end(), 0);
  std::fill_n(trees.begin(), disk.corners, 0);
  CurveSlits slits;
  int vertices = static_cast<int>(disk.rest.cols());
  for (const auto& [length, curve] : by_length) {
    const int from = trees[static_cast<std::size_t>(curve->from)],
              to = trees[static_cast<std::size_t>(curve->to)];
    if (from == to) continue;
    std::ranges::replace(trees, from, to);
    for (const std::uint64_t edge :
         {directed_edge(curve->from, curve->to), directed_edge(curve->to, curve->from)})
      slits[edge] = {curve, vertices};
    vertices += static_cast<int>(curve->bends.cols());
  }
  return slits;
}

/// Goes round the disk once it is cut.
class OutlineWalk {
 public:
  OutlineWalk(const TriangulatedDisk& disk, const CurveSlits& slits) : disk_(disk), slits_(slits) {
    for (const Eigen::Vector3i& t : disk.triangles)
      for (int i = 0; i < 3; ++i) left_[directed_edge(t[i], t[(i + 1) % 3])] = t[(i + 2) % 3];
  }

  SlitDisks go_round() {
    const int start = 0, second = 1;
    int u = start, v = second;
    do {
      add(u, disk_.rest.col(u), disk_.deformed.col(u));
      add_bends(u, v);
      u = std::exchange(v, after(u, v));
    } while (u != start || v != second);
    SlitDisks disks;
    disks.vertices = std::move(vertices_);
    disks.vertex_count = 1 + *std::ranges::max_element(disks.vertices);
    disks.rest = columns(rest_);
    disks.deformed = columns(deformed_);
    return disks;
  }

 private:
  void add(int vertex, const Vec2& rest, const Vec2& deformed) {
    vertices_.push_back(vertex);
    rest_.push_back(rest);
    deformed_.push_back(deformed);
  }
  /// They divide the edge at rest evenly.
  void add_bends(int u, int v) {
    const auto slit = slits_.find(directed_edge(u, v));
    if (slit == slits_.end()) return;
    const auto& [curve, first] = slit->second;
    const Vec2 from = disk_.rest.col(curve->from), to = disk_.rest.col(curve->to);
    const int bends = static_cast<int>(curve->bends.cols());
    for (int i = 0; i < bends; ++i) {
      const int bend = curve->from == u ? i : bends - 1 - i;
      add(first + bend, from + (bend + 1.0) / (bends + 1.0) * (to - from), curve->bends.col(bend));
    }
  }
  /// Where the outline goes on from v: along the first side clockwise from the way back to u.
  int after(int u, int v) const {
    int w = left_.at(directed_edge(u, v));
    while (!is_side(v, w)) w = left_.at(directed_edge(w, v));
    return w;
  }
  bool is_side(int v, int w) const {
    return !left_.contains(directed_edge(w, v)) || slits_.contains(directed_edge(v, w));
  }
  static Points columns(const std::vector<Vec2>& points) {
    Points columns(2, static_cast<Eigen::Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i)
      columns.col(static_cast<Eigen::Index>(i)) = points[i];
    return columns;
  }

  const TriangulatedDisk& disk_;
  const CurveSlits& slits_;
  std::unordered_map<std::uint64_t, int> left_;  ///< third corners by directed edge
  std::vector<int> vertices_;
  std::vector<Vec2> rest_, deformed_;
};

}  // namespace

SlitDisks slit_along(const std::vector<CarriedCurves::Curve>& curves,
                     const TriangulatedDisk& disk) {
  const CurveSlits slits = shortest_slits(curves, disk);
  return OutlineWalk(disk, slits).go_round();
}

}  // namespace foldless
