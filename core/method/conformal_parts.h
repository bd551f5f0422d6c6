// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>

#include "core/mesh/triangle.h"

namespace foldless {

using Complex = std::complex<double>;

/// An affine map of the plane as z ↦ f_z z + f_z̄ z̄ + const: its similarity and what is left.
/// σ₁ = |f_z| + |f_z̄|, signed σ₂ = |f_z| − |f_z̄|, det J = |f_z|² − |f_z̄|².
struct ConformalParts {
  Complex f_z;
  Complex f_zbar;
};

inline ConformalParts conformal_parts(const Mat2& J) {
  return {0.5 * Complex(J(0, 0) + J(1, 1), J(1, 0) - J(0, 1)),
          0.5 * Complex(J(0, 0) - J(1, 1), J(1, 0) + J(0, 1))};
}

/// k with σ₁/σ₂ ≤ K and det J > 0 exactly when |f_z̄| ≤ k|f_z| and f_z ≠ 0.
inline double dilatation_bound(double K) { return (K - 1) / (K + 1); }

/// e^{i arg w}, or `otherwise` where w is too small to have a direction.
inline Complex direction_of(const Complex& w, const Complex& otherwise) {
  constexpr double kNoDirection = 1e-14;
  return std::abs(w) < kNoDirection ? otherwise : w / std::abs(w);
}

}  // namespace foldless
