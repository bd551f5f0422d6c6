// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/editor/editor.h"
#include "app/gui/extent.h"
#include "app/gui/layout.h"
#include "app/gui/sight.h"
#include "render/scene_renderer.h"
#include "render/transparency_squares.h"

namespace foldless {

/// The meshes under the panels: of the canvas, of the pane beside it, and of the lanes of a race.
/// Every function needs the GL context of the constructor.
class Scenes {
 public:
  /// Finds what is in sight; returns whether any of it differs from what was there before.
  /// `has_squares`: grey ones behind a drawing.
  bool follow(Editor& editor, const Layout& layout, Extent framebuffer, bool has_squares);
  /// Clears the framebuffer and draws what is in sight.
  void draw();
  /// The scale of the heat map on screen; nothing when that layer is off.
  const std::optional<HeatRange>& heat_range() const { return heat_range_; }
  /// A picture is still on its way to the graphics card: more frames are wanted.
  bool is_uploading() const { return !canvas_.has_whole_texture(); }
  /// Of the canvas, with all of its picture.
  SceneRenderer& canvas_renderer();

 private:
  bool follow_texture(Editor& editor);
  void add_lanes(std::size_t count);
  void draw(const SceneInSight& scene, const std::optional<HeatRange>& common);

  Sight sight_;
  SceneRenderer canvas_;
  TransparencySquares squares_;
  /// One a lane: each keeps its mesh on the graphics card.
  std::vector<std::unique_ptr<SceneRenderer>> lanes_;
  std::shared_ptr<const TexturePieces> image_;  ///< that they show
  std::optional<Box> place_;                    ///< of the image in the rest plane
  std::shared_ptr<const MeshParts> parts_;      ///< of their meshes
  std::optional<HeatRange> heat_range_;
};

}  // namespace foldless
