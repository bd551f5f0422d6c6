// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/distortion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace foldless {
namespace {

constexpr double kSmallest = 1e-12;    // keeps logarithms finite
constexpr double kLeastEnergy = 1e-6;  // of the largest; less is as good as none
constexpr double kLeastExtent = 1.01;  // max / min; less is rounding noise and shows as one colour

/// A triangle that is turned over lies beyond every scale.
double measure_of(const Vec2& sigma, HeatMeasure measure) {
  if (measure == HeatMeasure::area) return sigma[1] > 0 ? std::max(sigma.prod(), kSmallest) : 0;
  return sigma[1] > 0 ? sigma[0] / std::max(sigma[1], kSmallest)
                      : std::numeric_limits<double>::infinity();
}

HeatRange range_of(const std::vector<double>& values, HeatMeasure measure) {
  HeatRange range{.measure = measure};
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (std::size_t t = 0; t < values.size(); ++t) {
    if (!(values[t] > 0) || !std::isfinite(values[t])) continue;
    least = std::min(least, values[t]);
    if (values[t] <= most) continue;
    most = values[t];
    range.triangle_at_max = static_cast<int>(t);
  }
  if (most == 0) return range;
  range.min = measure == HeatMeasure::conformal ? 1 : least;
  if (measure == HeatMeasure::energy) range.min = std::max(least, kLeastEnergy * most);
  range.max = std::max(most, kLeastExtent * range.min);
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

Distortion distortion_of(std::vector<double> energy_densities) {
  const HeatRange range = range_of(energy_densities, HeatMeasure::energy);
  return {std::move(energy_densities), range};
}

std::optional<Distortion> heat_of(const Snapshot& snapshot,
                                  const std::vector<double>& energy_densities,
                                  const ViewOptions& options) {
  if (!options.layers.heat) return std::nullopt;
  const bool is_of_energy = options.heat_measure == HeatMeasure::energy;
  if (is_of_energy && energy_densities.empty()) return std::nullopt;
  Distortion distortion = is_of_energy ? distortion_of(energy_densities)
                                       : distortion_of(snapshot, options.heat_measure);
  if (options.heat_scale) {
    distortion.range.min = options.heat_scale->front();
    distortion.range.max = options.heat_scale->back();
  }
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
