// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/method/method.h"

namespace foldless {

/// A problem seen through a linear map of the plane, under which the rest mesh is as wide as high.
struct WhitenedProblem {
  Problem problem;
  Mat2 map;  ///< the positions of `problem` are `map` times those of the original
};

/// Whether a map is locally injective does not depend on linear maps of both planes, but energies
/// and the lengths of strides do: where triangles are a hundred times as long as wide nothing turns
/// that flips can help. The map is W with W S Wᵀ = s I, S the second moments of the area of the
/// rest mesh; its diagonal stays about 1. Nothing where the square root of the eigenvalues of S
/// differ by less than 20, as those of the drawings and bars do that are meant as they are, nor
/// where the mesh is not proved locally injective as seen through the map.
std::optional<WhitenedProblem> whitened_problem(const Problem& problem);

/// The mesh of a run on that problem as seen without the map, handles exactly on the targets of
/// `constraints` and the vertices of `original` at its rest positions, bit for bit. Nothing where
/// rounding leaves a mesh that is not locally injective.
std::optional<MeshPair> without_whitening(const MeshPair& whitened, const Mat2& map,
                                          const Problem& original);

}  // namespace foldless
