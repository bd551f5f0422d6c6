// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>

#include "core/mesh/triangle.h"

namespace foldless {

/// A point of the plane as a complex number.
inline std::complex<double> complex(const Vec2& p) { return {p.x(), p.y()}; }

/// The similarity z ↦ a (z − from) + to of the plane: |a| scales, arg a turns.
struct Similarity {
  std::complex<double> a = 1, from = 0, to = 0;

  Vec2 operator()(const Vec2& z) const;
};

/// The one that brings starts nearest to targets (both 2 × n) in the sense of least squares: a
/// translation where they have no extent. [Umeyama 91]
Similarity similarity_of(const Points& starts, const Points& targets);

/// Root of the sum of squares of what it leaves of the ways from starts to targets. [length]
double left_of_way(const Similarity& similarity, const Points& starts, const Points& targets);

}  // namespace foldless
