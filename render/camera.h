// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>

namespace foldless {

/// What part of the plane is on screen. World y points up. Pixels are framebuffer pixels; their
/// origin is the top left corner of the viewport and their y points down.
struct Camera {
  glm::dvec2 centre{0, 0};       ///< world point in the middle of the viewport
  double pixels_per_unit = 100;  ///< framebuffer pixels a unit of length, > 0

  bool operator==(const Camera&) const = default;
};

/// An axis-parallel box in world coordinates.
struct Box {
  glm::dvec2 min{0, 0};
  glm::dvec2 max{1, 1};

  bool operator==(const Box&) const = default;
};

/// `viewport` is its size in framebuffer pixels, here and below.
glm::dvec2 world_to_pixel(const Camera& camera, glm::dvec2 viewport, glm::dvec2 world);
glm::dvec2 pixel_to_world(const Camera& camera, glm::dvec2 viewport, glm::dvec2 pixel);

/// The camera magnified `factor` times; the world point under `pixel` stays under it. The scale is
/// kept within 1e-120 … 1e120 pixels a unit.
Camera zoomed_about(const Camera& camera, glm::dvec2 viewport, glm::dvec2 pixel, double factor);

/// The camera after the drawing was dragged by `pixels` (x right, y down).
Camera panned(const Camera& camera, glm::dvec2 pixels);

/// The camera that shows the whole box in the middle, at least `margin` pixels from the borders
/// where the viewport is large enough. A box without extent is shown at 100 pixels a unit.
Camera fit_to_box(const Box& box, glm::dvec2 viewport, double margin);

/// Where floats on the graphics card stand, so that they suffice at any place and for any unit:
/// local = (world − origin) / unit.
struct LocalFrame {
  glm::dvec2 origin{0, 0};
  double unit = 1;

  glm::vec2 to_local(glm::dvec2 world) const { return glm::vec2((world - origin) / unit); }
};

/// Local to clip coordinates: clip = scale · local + offset.
struct ClipTransform {
  glm::vec2 scale{1, 1};
  glm::vec2 offset{0, 0};
};

ClipTransform clip_transform(const Camera& camera, glm::dvec2 viewport, const LocalFrame& local);

}  // namespace foldless
