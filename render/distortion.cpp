// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/distortion.h"

#include <algorithm>
#include <cmath>

namespace foldless {
namespace {

constexpr double kSmallest = 1e-12;    // keeps logarithms finite
constexpr double kLeastExtent = 1.01;  // max / min; less is rounding noise and shows as one colour

double measure_of(const Vec2& sigma, HeatMeasure measure) {
  const double value = measure == HeatMeasure::conformal ? sigma[0] / std::max(sigma[1], kSmallest)
                                                         : sigma[0] * sigma[1];
  return std::max(value, kSmallest);
}

HeatRange range_of(const std::vector<double>& values, HeatMeasure measure) {
  HeatRange range{.measure = measure};
  if (values.empty()) return range;
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  range.min = measure == HeatMeasure::conformal ? 1 : *least;
  range.max = std::max(*most, kLeastExtent * range.min);
  range.triangle_at_max = static_cast<int>(most - values.begin());
  return range;
}

}  // namespace

Distortion distortion_of(const Snapshot& snapshot, HeatMeasure measure) {
  Distortion distortion;
  distortion.values.reserve(static_cast<std::size_t>(snapshot.triangles->cols()));
  for (const auto& t : snapshot.triangles->colwise()) {
    const Mat2 J = deformation_gradient(*snapshot.rest, snapshot.deformed, t);
    distortion.values.push_back(measure_of(signed_singular_values(J), measure));
  }
  distortion.range = range_of(distortion.values, measure);
  return distortion;
}

double position_on(const HeatRange& range, double value) {
  if (range.max <= range.min || value <= range.min) return 0;
  return std::min(std::log(value / range.min) / std::log(range.max / range.min), 1.0);
}

double value_at(const HeatRange& range, double t) {
  return range.min * std::pow(range.max / range.min, t);
}

}  // namespace foldless
