// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stop_token>
#include <vector>

#include "core/outline/alpha_map.h"
#include "core/outline/triangulate.h"

namespace foldless {

/// What of a picture is the figure, and how closely its outline follows it.
struct RegionOptions {
  double threshold = 0.1;  ///< alpha, 0 … 1, from which on a pixel belongs to the figure; > 0
  double margin = 2;       ///< pixels that the outline keeps away from the figure
  double simplify = 1;     ///< pixels by which corners that are left out may be off
  double speck_area = 16;  ///< pixels²; smaller parts are left out, smaller holes filled
};

/// The figure of a picture as regions that do not touch. Coordinates in pixels, the lower left
/// corner of the picture (0, 0), y up.
struct Regions {
  std::vector<Outline> outlines;  ///< boundaries counter-clockwise, holes clockwise
  int specks = 0;                 ///< parts that were left out; the largest part never is
  int filled_holes = 0;
};

/// Traces the figure and simplifies its outline. The regions stay within the picture. Pictures of
/// more than two million pixels are looked at in blocks that are as opaque as their most opaque
/// pixel. The same picture always gives the same regions; of no use once `stop` was requested.
/// Throws Error on a picture without pixels or without a figure, on one with more than a thousand
/// parts and holes, and on options out of range.
Regions regions_of(const AlphaMap& alpha, const RegionOptions& options,
                   const std::stop_token& stop = {});

}  // namespace foldless
