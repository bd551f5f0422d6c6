// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/triangle.h"

namespace foldless {

/// The solver's frame: rest and deformed positions times a power of two, so that the rest
/// bounding box has a diagonal in (½√2, √2]; deformed positions moved by `offset` first. Scaling
/// is exact. Rest positions are not moved (energies see only their differences), so they come
/// back bit for bit. Every absolute constant of the paper is tuned for a mesh of this size.
struct Normalisation {
  double scale = 1;            ///< power of two; normalised length = scale × input length
  Vec2 offset = Vec2::Zero();  ///< centre of the rest bounding box, input units

  Points to_unit_rest(const Points& rest) const { return rest * scale; }
  Points from_unit_rest(const Points& rest) const { return rest / scale; }
  Points to_unit(const Points& deformed) const;
  Points from_unit(const Points& deformed) const;
};

/// The frame for a rest mesh (2 × #V, at least one vertex).
Normalisation normalisation_for(const Points& rest);

}  // namespace foldless
