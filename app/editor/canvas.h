// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/triangle.h"
#include "render/camera.h"

namespace foldless {

/// A rectangle in framebuffer pixels of the canvas, y down.
struct PixelBox {
  Vec2 min = Vec2::Zero();
  Vec2 max = Vec2::Zero();

  bool contains(const Vec2& pixel) const {
    return (pixel.array() >= min.array()).all() && (pixel.array() <= max.array()).all();
  }
};

/// The part of the window that shows the mesh.
struct Canvas {
  Camera camera;
  int width = 1;        ///< framebuffer pixels
  int height = 1;       ///< framebuffer pixels
  double ui_scale = 1;  ///< framebuffer pixels in one design pixel

  glm::dvec2 size() const { return {width, height}; }
  Vec2 to_world(const Vec2& pixel) const;
  Vec2 to_pixel(const Vec2& world) const;
  /// Hit radius of handles and vertices: 10 px × UI scale. [framebuffer pixels]
  double hit_radius() const { return 10 * ui_scale; }
  /// A press becomes a drag beyond 4 px × UI scale. [framebuffer pixels]
  double drag_threshold() const { return 4 * ui_scale; }
};

}  // namespace foldless
