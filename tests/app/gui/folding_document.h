// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <numbers>
#include <string_view>

#include "core/energy/densities.h"
#include "core/mesh/generate.h"
#include "core/scene/scene_io.h"
#include "tests/app/gui/headless_editor.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {

/// Opens a disk whose boundary is held and whose middle ring should turn by 120°, paused, with the
/// energy lscm, whose minimiser is folded.
inline void open_folding_disk(HeadlessEditor& headless, std::string_view method) {
  const DiskOptions options{.rings = 8, .boundary_vertices = 32, .vertices = 145};
  const Shape shape = disk(options);
  Scene scene;
  scene.triangles = shape.triangles;
  scene.rest = shape.rest;
  scene.energy = find_density("lscm");
  scene.parameters.method = method;
  const Eigen::Rotation2Dd turn(120 * std::numbers::pi / 180);
  const auto add = [&](int vertex, const Vec2& target) {
    const int id = static_cast<int>(scene.handles.size());
    scene.handles.push_back({id, vertex, target});
  };
  for (const int v : disk_ring(options, 8)) add(v, shape.rest.col(v));
  for (const int v : disk_ring(options, 4)) add(v, turn * shape.rest.col(v));
  const TemporaryFolder folder;
  save_scene(scene, folder / "disk.json");
  headless.editor().files().open_shape(shape, "disk");
  headless.editor().playback().toggle_pause();  // and so it stays
  headless.editor().files().open(folder / "disk.json");
  headless.calm_down();
}

}  // namespace foldless::test
