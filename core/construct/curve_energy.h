// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/construct/carried_curves.h"
#include "core/construct/triangulated_disk.h"

namespace foldless {

/// Of a curve when its disk is deformed. [length]
double length_of(const CarriedCurves::Curve& curve, const Points& deformed);

/// What a class of maps costs, told without a map of it: the Dirichlet energy ¼ Σ w ℓ² of maps that
/// are linear by triangles at rest [PP93], w = cot + cot of the angles that an inner edge is
/// opposite to. There ℓ is the length of the edge deformed, here that of its curve, which bends
/// where the class winds. The outline, the same in all classes, is left out.
class CurveEnergy {
 public:
  explicit CurveEnergy(const TriangulatedDisk& disk);

  /// `curves`: of the inner edges at rest.
  double operator()(const std::vector<CarriedCurves::Curve>& curves) const;

 private:
  const TriangulatedDisk& disk_;
  std::vector<double> weights_;  ///< w, by curve
};

}  // namespace foldless
