// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

namespace foldless {

using Vec2 = Eigen::Vector2d;
using Mat2 = Eigen::Matrix2d;
using Points = Eigen::Matrix2Xd;     ///< 2 × #V, one vertex a column
using Triangles = Eigen::Matrix3Xi;  ///< 3 × #F, vertex indices of a triangle a column
using Edge = std::array<int, 2>;     ///< vertex indices, the smaller first

/// a × b, positive where b is to the left of a.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Signed area of the triangle a, b, c; positive when counter-clockwise. [length²]
inline double signed_area(const Vec2& a, const Vec2& b, const Vec2& c) {
  return 0.5 * ((b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()));
}

/// Signed area of one triangle of a mesh.
inline double signed_area(const Points& points, const Eigen::Vector3i& t) {
  return signed_area(points.col(t[0]), points.col(t[1]), points.col(t[2]));
}

/// Barycentric coordinates of a point in one triangle of a mesh; negative where it is outside.
inline Eigen::Vector3d barycentric_of(const Points& points, const Eigen::Vector3i& t,
                                      const Vec2& p) {
  const Vec2 a = points.col(t[0]), b = points.col(t[1]), c = points.col(t[2]);
  return Eigen::Vector3d(signed_area(b, c, p), signed_area(c, a, p), signed_area(a, b, p)) /
         signed_area(a, b, c);
}

/// Gradients of the three hat functions of a triangle of rest area `area`, one a column. [1/length]
inline Eigen::Matrix<double, 2, 3> hat_gradients(const Vec2& a, const Vec2& b, const Vec2& c,
                                                 double area) {
  Eigen::Matrix<double, 2, 3> g;
  g << b.y() - c.y(), c.y() - a.y(), a.y() - b.y(),  //
      c.x() - b.x(), a.x() - c.x(), b.x() - a.x();
  return g * (0.5 / area);
}

/// Deformation gradient J (2×2) of the affine map that takes rest triangle to deformed triangle.
inline Mat2 deformation_gradient(const Points& rest, const Points& deformed,
                                 const Eigen::Vector3i& t) {
  Mat2 r, d;
  r << rest.col(t[1]) - rest.col(t[0]), rest.col(t[2]) - rest.col(t[0]);
  d << deformed.col(t[1]) - deformed.col(t[0]), deformed.col(t[2]) - deformed.col(t[0]);
  Mat2 adjugate;
  adjugate << r(1, 1), -r(0, 1), -r(1, 0), r(0, 0);
  return d * adjugate * (1 / (r(0, 0) * r(1, 1) - r(0, 1) * r(1, 0)));
}

/// Singular values σ₁ ≥ |σ₂| of J; σ₂ carries the sign of det J.
inline Vec2 signed_singular_values(const Mat2& J) {
  const auto length = [](double x, double y) { return std::sqrt(x * x + y * y); };
  const double conformal = 0.5 * length(J(0, 0) + J(1, 1), J(1, 0) - J(0, 1));
  const double anticonformal = 0.5 * length(J(0, 0) - J(1, 1), J(1, 0) + J(0, 1));
  return {conformal + anticonformal, conformal - anticonformal};
}

}  // namespace foldless
