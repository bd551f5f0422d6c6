// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace foldless {

/// #V × 2 in rows, a vertex a row. [length]
using PointMatrix = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;
/// #F × 3 in rows, the vertices of a triangle a row, counted from 0, counter-clockwise.
using TriangleMatrix = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;
/// Barycentric coordinates, a point a row; they add up to 1. [dimensionless]
using CoordinateMatrix = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// What functions take: such a matrix, or memory that lies like one. Nothing is copied then.
using PointsRef = Eigen::Ref<const PointMatrix>;
using TrianglesRef = Eigen::Ref<const TriangleMatrix>;
using CoordinatesRef = Eigen::Ref<const CoordinateMatrix>;
using IndicesRef = Eigen::Ref<const Eigen::VectorXi>;

/// How the vertices of a remeshed mesh lie in the mesh that it was made of, to carry over what a
/// caller keeps at vertices (texture coordinates, colours, weights).
struct Parents {
  /// Of every output vertex the input triangle that it lies in at rest, #U; −1 for a vertex that no
  /// triangle uses.
  Eigen::VectorXi triangles;
  /// Of every output vertex its barycentric coordinates there, #U × 3, none below 0; 1 and twice 0
  /// for an input vertex, 0 for one that no triangle uses.
  CoordinateMatrix coordinates;
  /// Of every input vertex its output vertex, #V.
  Eigen::VectorXi outputs;
};

}  // namespace foldless
