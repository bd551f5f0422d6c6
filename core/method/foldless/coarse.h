// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/method/foldless/workspace.h"
#include "core/method/method.h"

namespace foldless {

/// Which meshes are coarsened, and how far.
struct CoarseSettings {
  int dense_from = 2000;      ///< vertices from which it was measured to pay
  int least_vertices = 1000;  ///< of a coarse mesh, about
  int ratio = 4;              ///< vertices of the fine mesh to one of the coarse, about
  double short_way = 0.05;    ///< of the handle that goes farthest, too little to pay [D]
};

/// Coarse-to-fine, the paper's future work: the problem is solved on a mesh of fewer vertices
/// first, and the fine mesh begins with the map of that one. A coarse mesh that is dense itself
/// begins so too. Components without a handle are not coarsened, for they stay as they are.
class Coarse {
 public:
  /// Nothing where the mesh is not dense, where handles are near their targets, or where few
  /// vertices may go.
  static std::optional<Coarse> of(const Problem& problem, const CoarseSettings& settings);

  Coarse(const Coarse& other);
  Coarse& operator=(const Coarse& other);
  Coarse(Coarse&&) noexcept = default;
  Coarse& operator=(Coarse&&) noexcept = default;

  /// One step of the coarse run, whose record `iteration` is. What that run spent so far becomes
  /// what the workspace spent, which has not been worked on before. Arrives when the run has its
  /// handles on their targets and the workspace has taken its map over. Locks when the run ended
  /// otherwise, or when the fine mesh would fold; the fine mesh is then as it was.
  Progress step(Workspace& workspace, std::stop_token token, Iteration& iteration);

 private:
  Coarse(std::vector<int> vertices, std::unique_ptr<Method> run);

  std::vector<int> vertices_;  ///< index in the fine mesh of each of the first of the coarse
  std::unique_ptr<Method> run_;
};

}  // namespace foldless
