// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy/densities.h"
#include "core/scene/scene.h"
#include "tests/support/ribbons.h"

namespace foldless::test {

/// A scene of crossing_ribbon() as it lies.
inline Scene crossing_scene() {
  const Snapshot crossing = crossing_ribbon();
  Scene scene;
  scene.triangles = *crossing.triangles;
  scene.rest = *crossing.rest;
  scene.energy = find_density("arap");
  scene.state = SceneState{*crossing.triangles, *crossing.rest, crossing.deformed};
  scene.handles = crossing.handles;
  return scene;
}

}  // namespace foldless::test
