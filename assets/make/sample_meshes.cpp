// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/sample_meshes.h"

#include "assets/make/fill_inside.h"
#include "core/outline/shapes.h"

namespace foldless::samples {
namespace {

Shape mesh_of(const Drawing& drawing, int points, const TriangulateOptions& options) {
  return triangulate(sampled(drawing, points), options);
}

}  // namespace

// Sampling and bounds of the figures are chosen so that the alligator and
// the cowboy have the sizes of Table 1.
std::vector<SampleMesh> sample_meshes() {
  return {
      {"disk_coarse", disk(kCoarseDisk)},
      {"disk_dense", disk(kDenseDisk)},
      {"grid_coarse", grid(kCoarseGrid)},
      {"grid_dense", grid(kDenseGrid)},
      {"gingerbread", mesh_of(gingerbread(), 112, {.edge_length = 0.1275, .min_angle = 30})},
      {"alligator", mesh_of(alligator(), 612, {.edge_length = 0, .min_angle = 19.2})},
      {"cowboy", filled_inside(mesh_of(cowboy(), 65, {.edge_length = 0.4, .min_angle = 25}), 200)},
      {"bar_with_hole", mesh_of(bar_with_hole(), 90, {.edge_length = 0.12, .min_angle = 28})},
  };
}

}  // namespace foldless::samples
