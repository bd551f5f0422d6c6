// SPDX-License-Identifier: GPL-3.0-or-later
// Frames as a solver leaves them, without one: a map over a triangulation of its own.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <random>

#include "core/mesh/mesh_pair.h"
#include "core/snapshot.h"
#include "tests/support/meshes.h"

namespace foldless::test {

using PlaneMap = std::function<Vec2(const Vec2&)>;

/// The triangles round a vertex are counter-clockwise and, as those of a solver, no needles.
inline bool is_good_round(const MeshPair& mesh, int v) {
  for (const Points* points : {&mesh.rest(), &mesh.deformed()})
    for (const int t : mesh.triangles_of_vertex(v)) {
      const Eigen::Vector3i c = mesh.triangles().col(t);
      double longest = 0;
      for (int k = 0; k < 3; ++k)
        longest =
            std::max(longest, (points->col(c[(k + 1) % 3]) - points->col(c[k])).squaredNorm());
      if (!(signed_area(*points, c) > 0.02 * longest)) return false;
    }
  return true;
}

inline std::shared_ptr<const Snapshot> snapshot_of(const MeshPair& mesh, int original_vertices) {
  auto snapshot = std::make_shared<Snapshot>();
  snapshot->triangles = std::make_shared<const Triangles>(mesh.triangles());
  snapshot->rest = std::make_shared<const Points>(mesh.rest());
  snapshot->deformed = mesh.deformed();
  snapshot->original_vertices = original_vertices;
  return snapshot;
}

/// The mesh with its vertices mapped, then edges split and flipped at random: the splits are moved
/// a little, so that the map is bent there.
inline std::shared_ptr<const Snapshot> remeshed_frame(const Fixture& f, const PlaneMap& map,
                                                      std::mt19937& random, int changes) {
  Points mapped(2, f.rest.cols());
  for (Eigen::Index v = 0; v < f.rest.cols(); ++v) mapped.col(v) = map(f.rest.col(v));
  MeshPair mesh(f.triangles, f.rest, mapped);
  const auto any = [&](int count) {
    return std::uniform_int_distribution<int>(0, count - 1)(random);
  };
  for (int k = 0; k < changes; ++k) {
    const int e = any(mesh.edge_count());
    if (k % 3 == 0) {
      const int v = mesh.split_edge(e, 0.3 + 0.04 * any(10));
      Points deformed = mesh.deformed();
      const Vec2 place = deformed.col(v);
      deformed.col(v) = 0.5 * (place + map(mesh.rest().col(v)));
      mesh.set_deformed(deformed);
      if (is_good_round(mesh, v)) continue;
      deformed.col(v) = place;
      mesh.set_deformed(deformed);
    } else if (!mesh.is_boundary_edge(e) && mesh.is_flip_legal(e)) {
      mesh.flip(e);
      const auto [c, d] = mesh.edge(e);
      if (!is_good_round(mesh, c) || !is_good_round(mesh, d)) mesh.flip(e);
    }
  }
  return snapshot_of(mesh, static_cast<int>(f.rest.cols()));
}

}  // namespace foldless::test
