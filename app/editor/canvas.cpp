// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/canvas.h"

namespace foldless {

Vec2 Canvas::to_world(const Vec2& pixel) const {
  const glm::dvec2 world = pixel_to_world(camera, size(), {pixel.x(), pixel.y()});
  return {world.x, world.y};
}

Vec2 Canvas::to_pixel(const Vec2& world) const {
  const glm::dvec2 pixel = world_to_pixel(camera, size(), {world.x(), world.y()});
  return {pixel.x, pixel.y};
}

}  // namespace foldless
