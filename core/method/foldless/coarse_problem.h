// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/method/method.h"

namespace foldless {

/// Which meshes are coarsened, and how far.
struct CoarseSettings {
  int dense_from = 2000;      ///< vertices from which it pays
  int least_vertices = 1000;  ///< of a coarse mesh, about
  int ratio = 4;              ///< vertices of the fine mesh to one of the coarse, about
  double short_way = 0.05;    ///< of the handle that goes farthest, too little to pay [D]
};

/// A problem on a coarser mesh over the same domain: the paper's future work.
struct CoarseProblem {
  Problem problem;
  std::vector<int> vertices;  ///< index in the fine mesh of each of its vertices, ascending
};

/// Nothing where the mesh is not dense, where handles are near their targets, or where few vertices
/// may go, or once the token is set.
std::optional<CoarseProblem> coarse_problem(const Problem& problem, const CoarseSettings& settings,
                                            const std::stop_token& token = {});

}  // namespace foldless
