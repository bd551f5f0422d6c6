// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/snapshot.h"
#include "render/view_options.h"

namespace foldless {

/// The scale of a heat map: logarithmic from `min` (first colour) to `max` (last colour).
struct HeatRange {
  HeatMeasure measure = HeatMeasure::conformal;
  double min = 1;           ///< dimensionless, > 0
  double max = 1;           ///< ≥ min
  int triangle_at_max = 0;  ///< or kElsewhere
};
/// The largest value is that of another mesh on the same scale.
inline constexpr int kElsewhere = -1;

/// Distortion of each triangle, dimensionless. [σ₁/σ₂, A′/A or ψ]
struct Distortion {
  std::vector<double> values;  ///< one a triangle; of those turned over ∞, or 0 for the area
  HeatRange range;             ///< covers the others; conformal starts at 1
};

/// Of the snapshot's map from rest to deformed mesh.
Distortion distortion_of(const Snapshot& snapshot, HeatMeasure measure);

/// The same of energies per rest area, which whoever knows the energy computes. The scale has six
/// decades at most: beneath them energy is as good as none.
Distortion distortion_of(std::vector<double> energy_densities);

/// What the heat layer shows: the measure and the scale of the options. Nothing when it is off, and
/// where it is of the energy and `energy_densities` is empty.
std::optional<Distortion> heat_of(const Snapshot& snapshot,
                                  const std::vector<double>& energy_densities,
                                  const ViewOptions& options);

/// Where a value is on the scale, in [0, 1]; 0 on a scale without extent.
double position_on(const HeatRange& range, double value);
/// The value at `t` in [0, 1] of the scale: inverse of position_on().
double value_at(const HeatRange& range, double t);

}  // namespace foldless
