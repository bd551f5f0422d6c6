// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/triangle.h"

namespace foldless {

/// det J = A′/A.
inline double determinant(const Mat2& J) { return J(0, 0) * J(1, 1) - J(0, 1) * J(1, 0); }

/// The cofactors of J: ∂ det J / ∂J.
inline Mat2 cofactors(const Mat2& J) {
  Mat2 result;
  result << J(1, 1), -J(1, 0), -J(0, 1), J(0, 0);
  return result;
}

}  // namespace foldless
