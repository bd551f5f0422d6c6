// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/triangle.h"

namespace foldless {

/// A disk and its image, cut open along corresponding slits from the boundary, and from slits, to
/// all of some points inside: two polygons whose corners correspond, without points inside.
struct SlitDisks {
  Points rest, deformed;  ///< corners, which go round the tip of a slit by a full turn
  /// What every corner is: the first are the corners of the boundary, the next the points inside,
  /// the others bends of slits; those on both banks of a slit are one.
  std::vector<int> vertices;
  int vertex_count = 0;
  Triangles rest_triangles, deformed_triangles;  ///< i < j < k; none from braided()
  double length = 0;  ///< of slits, in both, in diagonals; 0 from braided()
};

/// A disk with points inside.
struct DottedDisk {
  Points outline;  ///< counter-clockwise
  Points inside;
};

/// Cuts both disks, whose corners and points correspond, in some ways of which every one is another
/// class of maps: the slit that is the shortest in both together comes first, and in all ways but
/// one points are preferred at random, the same every time. The shortest slits come first, which
/// leave the fewest crossings. Nothing where an outline bounds no disk or a point is not inside, or
/// the disk lies over itself there.
std::vector<SlitDisks> slit_open(const DottedDisk& rest, const DottedDisk& deformed);

}  // namespace foldless
