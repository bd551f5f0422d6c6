// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outline/simplify.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyline_simplification_2/Squared_distance_cost.h>
#include <CGAL/Polyline_simplification_2/simplify.h>

#include <algorithm>
#include <utility>

namespace foldless {
namespace {

namespace PS = CGAL::Polyline_simplification_2;
using PlaneKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using PlaneStorage =
    CGAL::Triangulation_data_structure_2<PS::Vertex_base_2<PlaneKernel>,
                                         CGAL::Constrained_triangulation_face_base_2<PlaneKernel>>;
using PlaneTriangulation = CGAL::Constrained_Delaunay_triangulation_2<PlaneKernel, PlaneStorage,
                                                                      CGAL::Exact_predicates_tag>;
using Polylines = CGAL::Constrained_triangulation_plus_2<PlaneTriangulation>;

/// Without corners that lie exactly between their neighbours: there are long rows of them along
/// the sides of a picture, and what follows is slow on long rows.
Loop without_straight_corners(const Loop& loop) {
  Loop bent;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2& before = loop[(i + loop.size() - 1) % loop.size()];
    if (cross(loop[i] - before, loop[(i + 1) % loop.size()] - loop[i]) != 0)
      bent.push_back(loop[i]);
  }
  return bent;
}

constexpr double kStraight = 1e-9;

}  // namespace

std::vector<Loop> simplified(const std::vector<Loop>& loops, double distance) {
  Polylines polylines;
  std::vector<Polylines::Constraint_id> ids;
  std::vector<PlaneKernel::Point_2> corners;
  for (const Loop& loop : loops) {
    corners.clear();
    for (const Vec2& p : without_straight_corners(loop)) corners.emplace_back(p.x(), p.y());
    // The first corner always stays: the outermost one is a good corner to keep.
    std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
    ids.push_back(polylines.insert_constraint(corners.begin(), corners.end(), true));
  }
  // CGAL takes corners whose cost is less than the threshold.
  const double threshold = std::max(distance * distance, kStraight * kStraight);
  // One after the other: all at once they would be taken up in the order of their addresses.
  for (const auto id : ids)
    PS::simplify(polylines, id, PS::Squared_distance_cost(),
                 PS::Stop_above_cost_threshold(threshold));
  std::vector<Loop> result;
  for (const auto id : ids) {
    Loop loop;
    for (auto v = polylines.vertices_in_constraint_begin(id);
         v != polylines.vertices_in_constraint_end(id); ++v)
      loop.emplace_back((*v)->point().x(), (*v)->point().y());
    loop.pop_back();  // the first corner again
    result.push_back(std::move(loop));
  }
  return result;
}

}  // namespace foldless
