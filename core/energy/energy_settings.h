// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy/density.h"

namespace foldless {

/// What a deformed triangle is compared with.
enum class Reference {
  rest,        ///< its triangle in M
  equilateral  ///< an equilateral triangle of the same area: E forgets the map's distortion
};

/// Which energy E of eq. 5 is minimised, in the frame of the mesh it is used on.
struct EnergySettings {
  const Density* density = nullptr;  ///< ψ
  double alpha = 5e7;                ///< weight of the penalty
  double beta = 0.01;         ///< weight of a triangle's barrier χ_t; 0 keeps only the bound
  double delta = 1e-5;        ///< smallest A′/A, in (0, 1)
  bool area_weighted = true;  ///< false: unit_area Σ ψ instead of Σ A ψ
  double unit_area = 1;       ///< D², so that no sum depends on the unit of length [length²]
  bool barrier_area_weighted = false;  ///< true: Σ β A χ instead of Σ β χ
  Reference reference = Reference::rest;
  double conformal_weight = 0;  ///< of conformal_power_value() of every triangle, large or small
  int conformal_power = 2;      ///< its q
  /// κ, the weight per rest area of the barrier on the gaps of boundary vertices; 0: neither the
  /// barrier nor its bound on steps, and boundary vertices may overlap themselves.
  double gap_weight = 0;

  bool guards_boundary() const { return gap_weight > 0; }
};

}  // namespace foldless
