// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "core/handle.h"
#include "core/mesh/triangle.h"

namespace foldless {

/// Beyond them the energy of the rest is rounding.
inline constexpr double kLeastStiffness = 1e-3, kLargestStiffness = 1e6;

/// A stroke of a brush over the rest mesh: what it covers is so many times as stiff.
struct StiffStroke {
  Points line;        ///< its middle, 2 × one point or more [length]
  double radius = 0;  ///< > 0 [length]
  double factor = 1;  ///< on the energy, > 0; 1 takes back what earlier strokes did

  bool operator==(const StiffStroke& other) const;
};

/// A factor on the energy as a function on the plane of the rest mesh, which flips and splits
/// therefore do not move: that of the last stroke that covers a point, 1 where there is none, times
/// those of all disks that cover it, within kLeastStiffness and kLargestStiffness.
class Stiffness {
 public:
  /// `disks`: strokes of one point, of handles.
  explicit Stiffness(std::vector<StiffStroke> strokes, std::vector<StiffStroke> disks = {});

  const std::vector<StiffStroke>& strokes() const { return strokes_; }
  /// The factor at a point.
  double at(const Vec2& point) const;
  /// The same function in another unit of length.
  Stiffness scaled(double factor) const;

  bool operator==(const Stiffness& other) const {
    return strokes_ == other.strokes_ && disks_ == other.disks_;
  }

 private:
  std::vector<StiffStroke> strokes_, disks_;
  std::vector<Eigen::AlignedBox2d> boxes_;  ///< of what each stroke covers
};

/// What strokes and the disks of handles make of a rest mesh (2 × #V); null: 1 everywhere.
/// `strokes` may be null.
std::shared_ptr<const Stiffness> stiffness_with(const std::shared_ptr<const Stiffness>& strokes,
                                                const std::vector<Handle>& handles,
                                                const Points& rest);

}  // namespace foldless
