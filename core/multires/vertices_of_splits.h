// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/multires/coarsen.h"

namespace foldless {

/// The vertices that splits of a coarse mesh made, those after the first `coarse.vertices.size()`,
/// as vertices of a fine mesh over the same rest domain, each made when it is asked for. Both
/// meshes outlive it.
class VerticesOfSplits {
 public:
  VerticesOfSplits(const CoarseMesh& coarse, MeshPair& fine);

  /// The vertex of the fine mesh where vertex `v` of the coarse one is at rest: one that is there,
  /// or a new one, by a split of a fine triangle or of an edge, of the boundary only where `v` lies
  /// on it. The map stays what it is. Nothing where rounding is in the way.
  std::optional<int> vertex_at(int v);

 private:
  int triangle_near(int v) const;
  std::optional<int> make(int v, int triangle, const Eigen::Vector3d& barycentric);

  const CoarseMesh& coarse_;
  MeshPair& fine_;
  std::vector<int> vertices_;  ///< of every vertex of the coarse mesh; −1 where none was made
};

}  // namespace foldless
