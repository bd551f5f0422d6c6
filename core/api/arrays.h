// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <foldless/mesh.h>

#include "core/mesh/triangle.h"

namespace foldless {

// Rows of the caller are columns here: the same memory.

inline Points points_of(const PointsRef& rows) { return rows.transpose(); }
inline PointMatrix rows_of(const Points& points) { return points.transpose(); }
inline TriangleMatrix rows_of(const Triangles& triangles) { return triangles.transpose(); }

/// The triangles of a caller. Throws Error where there is none, or one names a vertex that is not
/// there.
Triangles triangles_of(const TrianglesRef& rows, Eigen::Index vertices);

/// Throws Error `WHAT is … ` where rows of points are not as many as `rows`, which `of` names, or a
/// number is not finite.
void check_points(const PointsRef& points, const char* what, Eigen::Index rows, const char* of);

}  // namespace foldless
