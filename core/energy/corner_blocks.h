// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy/matrix2.h"

namespace foldless {

/// The blocks of corners 1 and 2 in the Hessian of a triangle. As a whole it is symmetric.
template <class Real>
struct BlocksOf {
  Matrix2<Real> of_11, of_12, of_22;

  /// For every pair of corners: x_j y_kᵀ. The sum of what is added has to be symmetric.
  FOLDLESS_INLINED void add(const Matrix2<Real>& x, const Matrix2<Real>& y) {
    of_11 = of_11 + Matrix2<Real>{x.a * y.a, x.b * y.a, x.a * y.b, x.b * y.b};
    of_12 = of_12 + Matrix2<Real>{x.a * y.c, x.b * y.c, x.a * y.d, x.b * y.d};
    of_22 = of_22 + Matrix2<Real>{x.c * y.c, x.d * y.c, x.c * y.d, x.d * y.d};
  }
  /// ∇φ_j · ∇φ_k times I, and ∇φ_j × ∇φ_k times a quarter turn.
  FOLDLESS_INLINED void add(const Real& of_identity, const Real& of_determinant,
                            const Matrix2<Real>& g) {
    add_identity(of_identity * (g.a * g.a + g.b * g.b), of_11);
    add_identity(of_identity * (g.a * g.c + g.b * g.d), of_12);
    add_identity(of_identity * (g.c * g.c + g.d * g.d), of_22);
    const Real cross = of_determinant * determinant(g);
    of_12.c += cross;
    of_12.b -= cross;
  }

 private:
  FOLDLESS_INLINED static void add_identity(const Real& factor, Matrix2<Real>& m) {
    m.a += factor;
    m.d += factor;
  }
};

// Moving all corners alike changes nothing: what belongs to corner 0 follows.

/// The gradient by a corner, from those by corners 1 and 2, one a column.
inline Vec2 gradient_of_corner(const Matrix2<double>& gradients, int corner) {
  const auto& [a, b, c, d] = gradients;
  if (corner == 0) return {-(a + c), -(b + d)};
  return corner == 1 ? Vec2(a, b) : Vec2(c, d);
}

/// That of block_of_corners() for row ≤ column.
FOLDLESS_INLINED Matrix2<double> upper_block(const BlocksOf<double>& blocks, int row, int column) {
  const auto& [of_11, of_12, of_22] = blocks;
  if (row > 0) return row < column ? of_12 : row == 1 ? of_11 : of_22;
  const Matrix2<double> of_01 = -(of_11 + transposed(of_12));
  const Matrix2<double> of_02 = -(of_12 + of_22);
  return column == 0 ? -(of_01 + of_02) : column == 1 ? of_01 : of_02;
}

/// The block of two corners in the Hessian of a triangle: rows of `row`, columns of `column`.
FOLDLESS_INLINED Matrix2<double> block_of_corners(const BlocksOf<double>& blocks, int row,
                                                  int column) {
  return row > column ? transposed(upper_block(blocks, column, row))
                      : upper_block(blocks, row, column);
}

/// The two columns of a corner in the Hessian of a triangle.
inline Eigen::Matrix<double, 6, 2> columns_of_corner(const BlocksOf<double>& blocks, int corner) {
  Eigen::Matrix<double, 6, 2> columns;
  for (int row = 0; row < 3; ++row)
    columns.middleRows<2>(2 * row) = eigen_of(block_of_corners(blocks, row, corner));
  return columns;
}

}  // namespace foldless
