// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/quality.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/threads/team.h"

namespace foldless {

namespace {

struct TriangleQuality {
  double area_ratio = 0;
  double conformal_distortion = 0;  ///< where the area ratio is positive
};

// σ₂ from the areas: σ₁ − |σ₂| loses it to cancellation in needles.
TriangleQuality triangle_quality(const Points& rest, const Points& deformed,
                                 const Eigen::Vector3i& t) {
  TriangleQuality quality{signed_area(deformed, t) / signed_area(rest, t)};
  if (!(quality.area_ratio > 0)) return quality;
  const double sigma1 = signed_singular_values(deformation_gradient(rest, deformed, t))[0];
  quality.conformal_distortion = sigma1 * sigma1 / quality.area_ratio;
  return quality;
}

std::vector<TriangleQuality> qualities_of(const Triangles& triangles, const Points& rest,
                                          const Points& deformed) {
  std::vector<TriangleQuality> all(static_cast<std::size_t>(triangles.cols()));
  constexpr std::ptrdiff_t kTogether = 2048;
  in_ranges(triangles.cols(), kTogether, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    for (std::ptrdiff_t i = begin; i < end; ++i)
      all[static_cast<std::size_t>(i)] = triangle_quality(rest, deformed, triangles.col(i));
  });
  return all;
}

}  // namespace

Quality quality_of(const Triangles& triangles, const Points& rest, const Points& deformed) {
  Quality quality{std::numeric_limits<double>::infinity(), 1, 0};
  int unfolded = 0;
  for (const auto& [area_ratio, conformal] : qualities_of(triangles, rest, deformed)) {
    quality.min_area_ratio = std::min(quality.min_area_ratio, area_ratio);
    if (!(area_ratio > 0)) continue;
    ++unfolded;
    quality.max_conformal_distortion = std::max(quality.max_conformal_distortion, conformal);
    quality.mean_conformal_distortion += conformal;
  }
  quality.mean_conformal_distortion = unfolded ? quality.mean_conformal_distortion / unfolded : 1;
  return quality;
}

double conformal_distortion(const Points& rest, const Points& deformed, const Eigen::Vector3i& t) {
  return triangle_quality(rest, deformed, t).conformal_distortion;
}

double smallest_angle(const Shape& shape) {
  double smallest = std::numbers::pi;
  for (const auto& t : shape.triangles.colwise())
    for (int k = 0; k < 3; ++k) {
      const Vec2 a = shape.rest.col(t[(k + 1) % 3]) - shape.rest.col(t[k]);
      const Vec2 b = shape.rest.col(t[(k + 2) % 3]) - shape.rest.col(t[k]);
      smallest = std::min(smallest, std::atan2(cross(a, b), a.dot(b)));
    }
  return smallest * 180 / std::numbers::pi;
}

}  // namespace foldless
