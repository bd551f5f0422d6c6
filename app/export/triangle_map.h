// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

namespace foldless {

/// An affine map of the plane, x ↦ linear · x + offset.
struct AffineMap {
  glm::dmat2 linear{1};
  glm::dvec2 offset{0, 0};

  glm::dvec2 operator()(glm::dvec2 x) const { return linear * x + offset; }
};

/// The map of one triangle to another. Infinite or NaN where the first has no area.
inline AffineMap triangle_map(const std::array<glm::dvec2, 3>& from,
                              const std::array<glm::dvec2, 3>& to) {
  const glm::dmat2 sides_from(from[1] - from[0], from[2] - from[0]);
  const glm::dmat2 sides_to(to[1] - to[0], to[2] - to[0]);
  const glm::dmat2 linear = sides_to * glm::inverse(sides_from);
  return {linear, to[0] - linear * from[0]};
}

/// First `inner`, then `outer`.
inline AffineMap composed(const AffineMap& outer, const AffineMap& inner) {
  return {outer.linear * inner.linear, outer(inner.offset)};
}

}  // namespace foldless
