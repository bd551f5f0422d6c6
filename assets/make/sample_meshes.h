// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/mesh/generate.h"

namespace foldless::samples {

/// The disks of the paper's Table 1.
inline constexpr DiskOptions kCoarseDisk{.rings = 10, .boundary_vertices = 42, .vertices = 293};
inline constexpr DiskOptions kDenseDisk{.rings = 30, .boundary_vertices = 120, .vertices = 2483};
/// The grids of the paper's Table 1.
inline constexpr GridOptions kCoarseGrid{.columns = 5, .rows = 5};
inline constexpr GridOptions kDenseGrid{
    .columns = 10, .rows = 10, .diagonal = Diagonal::alternating};

/// A mesh of assets/meshes: `name`.obj.
struct SampleMesh {
  std::string name;
  Shape shape;
};

/// All meshes of assets/meshes.
std::vector<SampleMesh> sample_meshes();

}  // namespace foldless::samples
