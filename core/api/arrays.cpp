// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/api/arrays.h"

#include <string>

#include "core/error.h"

namespace foldless {

Triangles triangles_of(const TrianglesRef& rows, Eigen::Index vertices) {
  if (rows.rows() == 0) throw Error("the mesh has no triangle; give at least one");
  for (Eigen::Index t = 0; t < rows.rows(); ++t)
    for (const int v : rows.row(t))
      if (v < 0 || v >= vertices)
        throw Error("triangle " + std::to_string(t) + " names the vertex " + std::to_string(v) +
                    ", but the vertices are 0 to " + std::to_string(vertices - 1));
  return rows.transpose();
}

void check_points(const PointsRef& points, const char* what, Eigen::Index rows, const char* of) {
  if (points.rows() != rows)
    throw Error("there are " + std::to_string(points.rows()) + " rows of " + what + " for " +
                std::to_string(rows) + ' ' + of + "; give one for each");
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    if (!points.row(i).allFinite())
      throw Error("row " + std::to_string(i) + " of " + what +
                  " is not finite; every coordinate must be a number");
}

}  // namespace foldless
