// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "app/bench/bench_scene.h"
#include "app/bench/plane_map.h"
#include "app/bench/random_mesh.h"

namespace foldless {

/// A mesh, and the homeomorphism of the plane whose images of `handles` are their targets.
struct RandomDeformation {
  RandomMesh mesh;
  PlaneMap map;
  std::vector<int> handles;  ///< vertices, none twice
};

/// How demanding a scene is, by what its homeomorphism does: a row of difficulties().
struct Difficulty {
  std::string_view name;
  /// Draws the homeomorphism and the handles for a mesh; false when the mesh does not do for it.
  bool (*draw)(RandomNumbers& random, RandomDeformation& deformation);
};

/// `easy`, `medium`, `hard`; `fixed-boundary`: all boundary vertices are held, and the
/// homeomorphism leaves the boundary where it is; `crossing`: pairs of handles change places;
/// `swirl`: a disk of vertices turns by 180 degrees inside a held boundary.
std::span<const Difficulty> difficulties();

/// The deformation of scene `index` of the suite of a seed. It does not depend on how many scenes
/// are drawn. Throws Error when a mesh of assets/meshes is missing.
RandomDeformation random_deformation(std::uint64_t seed, int index);

/// The scene itself: 3 to 12 handles, or with them the boundary, or a swirl's disk and boundary,
/// with their images as targets, rounded to multiples of 2^-20. Thirty scenes in a row have each
/// energy at each difficulty once. A continuous locally injective solution exists by construction;
/// a piecewise linear one on the given triangulation need not.
BenchScene random_scene(std::uint64_t seed, int index);

}  // namespace foldless
