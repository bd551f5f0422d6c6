// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/quality.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/threads/values_of_ranges.h"

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

/// Of some triangles.
struct QualitySum {
  double min_area_ratio = std::numeric_limits<double>::infinity();
  double max_conformal_distortion = 1;
  double sum_of_conformal_distortions = 0;
  int unfolded = 0;

  void add(const TriangleQuality& triangle) {
    min_area_ratio = std::min(min_area_ratio, triangle.area_ratio);
    if (!(triangle.area_ratio > 0)) return;
    max_conformal_distortion = std::max(max_conformal_distortion, triangle.conformal_distortion);
    sum_of_conformal_distortions += triangle.conformal_distortion;
    ++unfolded;
  }
  void add(const QualitySum& others) {
    min_area_ratio = std::min(min_area_ratio, others.min_area_ratio);
    max_conformal_distortion = std::max(max_conformal_distortion, others.max_conformal_distortion);
    sum_of_conformal_distortions += others.sum_of_conformal_distortions;
    unfolded += others.unfolded;
  }
};

}  // namespace

Quality quality_of(const Triangles& triangles, const Points& rest, const Points& deformed) {
  constexpr std::ptrdiff_t kTogether = 2048;
  const auto sums =
      values_of_ranges(triangles.cols(), kTogether, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
        QualitySum own;
        for (std::ptrdiff_t t = begin; t < end; ++t)
          own.add(triangle_quality(rest, deformed, triangles.col(t)));
        return own;
      });
  QualitySum all;
  for (const QualitySum& sum : sums) all.add(sum);
  return {all.min_area_ratio, all.max_conformal_distortion,
          all.unfolded ? all.sum_of_conformal_distortions / all.unfolded : 1};
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
