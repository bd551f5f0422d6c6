// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy/lanes.h"
#include "core/mesh/triangle.h"

namespace foldless {

/// [a c; b d]: of one triangle or of several.
template <class Real>
struct Matrix2 {
  Real a, b;  ///< the first column
  Real c, d;
};

FOLDLESS_INLINED Matrix2<double> matrix2(const Mat2& m) {
  return {m(0, 0), m(1, 0), m(0, 1), m(1, 1)};
}

FOLDLESS_INLINED Mat2 eigen_of(const Matrix2<double>& m) {
  Mat2 result;
  result << m.a, m.c, m.b, m.d;
  return result;
}

template <class Real>
FOLDLESS_INLINED Matrix2<Real> operator+(const Matrix2<Real>& m, const Matrix2<Real>& n) {
  return {m.a + n.a, m.b + n.b, m.c + n.c, m.d + n.d};
}
template <class Real>
FOLDLESS_INLINED Matrix2<Real> operator-(const Matrix2<Real>& m) {
  return {-m.a, -m.b, -m.c, -m.d};
}
template <class Real>
FOLDLESS_INLINED Matrix2<Real> operator*(const Real& factor, const Matrix2<Real>& m) {
  return {factor * m.a, factor * m.b, factor * m.c, factor * m.d};
}
template <class Real>
FOLDLESS_INLINED Matrix2<Real> operator*(const Matrix2<Real>& m, const Matrix2<Real>& n) {
  return {m.a * n.a + m.c * n.b, m.b * n.a + m.d * n.b, m.a * n.c + m.c * n.d,
          m.b * n.c + m.d * n.d};
}
template <class Real>
FOLDLESS_INLINED Matrix2<Real> transposed(const Matrix2<Real>& m) {
  return {m.a, m.c, m.b, m.d};
}
/// ‖m‖²_F.
template <class Real>
FOLDLESS_INLINED Real squared_norm(const Matrix2<Real>& m) {
  return (m.a * m.a + m.c * m.c) + (m.b * m.b + m.d * m.d);
}
template <class Real>
FOLDLESS_INLINED Real determinant(const Matrix2<Real>& m) {
  return m.a * m.d - m.c * m.b;
}
/// ∂ det m / ∂m.
template <class Real>
FOLDLESS_INLINED Matrix2<Real> cofactors(const Matrix2<Real>& m) {
  return {m.d, -m.c, -m.b, m.a};
}
/// Both columns by a quarter turn to the left.
template <class Real>
FOLDLESS_INLINED Matrix2<Real> turned(const Matrix2<Real>& m) {
  return {-m.b, m.a, -m.d, m.c};
}

}  // namespace foldless
