// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "core/mesh/triangle.h"

namespace foldless {

/// A stroke of a brush over the rest mesh: what it covers is so many times as stiff.
struct StiffStroke {
  Points line;        ///< its middle, 2 × one point or more [length]
  double radius = 0;  ///< > 0 [length]
  double factor = 1;  ///< on the energy, > 0; 1 takes back what earlier strokes did

  bool operator==(const StiffStroke& other) const;
};

/// A factor on the energy as a function on the plane of the rest mesh, which flips and splits
/// therefore do not move: that of the last stroke that covers a point, 1 where there is none.
class Stiffness {
 public:
  explicit Stiffness(std::vector<StiffStroke> strokes);

  const std::vector<StiffStroke>& strokes() const { return strokes_; }
  /// The factor at a point.
  double at(const Vec2& point) const;
  /// The same function in another unit of length.
  Stiffness scaled(double factor) const;

  bool operator==(const Stiffness& other) const { return strokes_ == other.strokes_; }

 private:
  std::vector<StiffStroke> strokes_;
  std::vector<Eigen::AlignedBox2d> boxes_;  ///< of what each covers
};

}  // namespace foldless
