// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/bench/random_numbers.h"
#include "core/mesh/shape.h"

namespace foldless {

/// A mesh of the suite and what its scenes need to know about it.
struct RandomMesh {
  std::string name;  ///< `grid`, `disk`, … : its kind
  Shape shape;
  std::vector<bool> is_boundary;  ///< of each vertex
  std::vector<double> clearance;  ///< of each vertex: distance to the nearest boundary edge
  double diagonal = 1;            ///< D of the rest bounding box
};

/// A mesh of random kind and size: most of 100 to 1500 triangles, one in twelve of up to 5000.
/// Constraints are multiples of 2^-20, so that they do not hang on a machine's last digits. Throws
/// Error when a mesh of assets/meshes is missing.
RandomMesh random_mesh(RandomNumbers& random);

/// A coordinate as the suite has it: the nearest multiple of 2^-20.
double suite_coordinate(double value);

}  // namespace foldless
