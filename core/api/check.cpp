// SPDX-License-Identifier: GPL-3.0-or-later
#include <foldless/check.h>

#include <limits>

#include "core/api/arrays.h"
#include "core/files/validate.h"
#include "core/mesh/injective.h"
#include "core/mesh/quality.h"

namespace foldless {
namespace {

Folds folds_of(const InjectivityReport& report) {
  return {report.inverted, report.degenerate, report.branch_vertices,
          report.overlapping_boundary_vertices};
}

}  // namespace

CheckedMap check(const PointsRef& rest, const TrianglesRef& triangles, const PointsRef& deformed) {
  check_points(rest, "rest positions", rest.rows(), "vertices");
  check_points(deformed, "deformed positions", rest.rows(), "vertices");
  const Triangles checked = triangles_of(triangles, rest.rows());
  MeshSource source;
  source.name = "mesh";
  check_connectivity(checked, static_cast<int>(rest.rows()), source);
  const Points before = points_of(rest), after = points_of(deformed);
  const InjectivityChecker checker(checked, static_cast<int>(rest.rows()));
  CheckedMap map{folds_of(checker.check(before)), folds_of(checker.check(after))};
  map.min_area_ratio = map.max_conformal_distortion = map.mean_conformal_distortion =
      std::numeric_limits<double>::quiet_NaN();
  if (map.rest.inverted + map.rest.degenerate > 0) return map;
  const Quality quality = quality_of(checked, before, after);
  map.min_area_ratio = quality.min_area_ratio;
  map.max_conformal_distortion = quality.max_conformal_distortion;
  map.mean_conformal_distortion = quality.mean_conformal_distortion;
  return map;
}

}  // namespace foldless
