// SPDX-License-Identifier: GPL-3.0-or-later
#include <foldless/session.h>
#include <foldless/solve.h>

#include "core/api/arrays.h"
#include "core/api/point_map.h"

namespace foldless {

PointMatrix Result::map(const PointsRef& points) const {
  return rows_of(point_map->at(points_of(points)));
}

PointMatrix Result::map(const IndicesRef& inputs, const CoordinatesRef& coordinates) const {
  return rows_of(point_map->at(inputs, coordinates.transpose()));
}

// NOLINTNEXTLINE(readability-function-size): the order that callers know from other libraries
Result solve(const PointsRef& rest, const TrianglesRef& triangles, const std::vector<int>& handles,
             const PointsRef& targets, const SolveOptions& options) {
  Session session(rest, triangles, handles, targets, options);
  session.run();
  return session.result();
}

}  // namespace foldless
