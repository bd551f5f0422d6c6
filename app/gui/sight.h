// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "app/editor/editor.h"
#include "app/gui/extent.h"
#include "app/gui/layout.h"
#include "render/scene_renderer.h"

namespace foldless {

/// A mesh in a part of the framebuffer, and all that its picture depends on but the texture.
struct SceneInSight {
  std::optional<std::size_t> lane = std::nullopt;  ///< of a race; nothing: the canvas
  std::shared_ptr<const Snapshot> pose;            ///< never null
  bool has_targets_at_rest = false;                ///< targets belong to the deformed mesh
  bool gives_heat_range = false;                   ///< to the legend
  bool shares_heat_scale = false;                  ///< with the others that do
  Viewport viewport;
  Camera camera;
  std::vector<int> selected = {};     ///< ids of handles
  std::optional<int> hovered = {};    ///< id of a handle
  std::vector<float> stiffness = {};  ///< of the triangles; empty: not shown
  ViewOptions options;
  std::optional<Box> squares = {};  ///< grey ones, seen through the picture; nothing: none
  const Density* energy = nullptr;  ///< that the heat map may show

  bool operator==(const SceneInSight&) const = default;
};

/// The meshes under the panels.
struct Sight {
  Extent framebuffer;
  Theme theme = Theme::dark;
  std::vector<SceneInSight> scenes;

  bool operator==(const Sight&) const = default;
};

/// What is to be seen now: a preview, the lanes of a race, or the document and what is beside it.
/// `has_squares`: behind a drawing.
Sight sight_of(Editor& editor, const Layout& layout, Extent framebuffer, bool has_squares);

}  // namespace foldless
