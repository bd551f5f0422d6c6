// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/scene.h"

namespace foldless {

MeshPair mesh_of(const Scene& scene) {
  const auto& state = scene.state;
  MeshPair mesh = state ? MeshPair(state->triangles, state->rest, state->deformed)
                        : MeshPair(scene.triangles, scene.rest);
  mesh.set_stiffness(stiffness_with(scene.stiffness, scene.handles, mesh.rest()));
  return mesh;
}

}  // namespace foldless
