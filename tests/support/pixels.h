// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <memory>

#include "core/snapshot.h"
#include "render/colormap.h"
#include "render/offscreen.h"
#include "render/scene_renderer.h"
#include "tests/support/meshes.h"

namespace foldless::test {

/// A snapshot of an undeformed mesh; every call has a revision of its own.
inline Snapshot undeformed(const Fixture& fixture) {
  static std::uint64_t revision = 0;
  Snapshot snapshot;
  snapshot.revision = ++revision;
  snapshot.triangles = std::make_shared<const Triangles>(fixture.triangles);
  snapshot.rest = std::make_shared<const Points>(fixture.rest);
  snapshot.deformed = fixture.rest;
  snapshot.original_vertices = static_cast<int>(fixture.rest.cols());
  return snapshot;
}

/// Options with every layer off, on the dark canvas.
inline ViewOptions bare_view() {
  ViewOptions options;
  for (const LayerRow& row : kLayerRows) options.layers.*row.shown = false;
  return options;
}

/// Largest difference of a channel between a pixel and a colour (sRGB, alpha 1 when opaque).
inline int difference(const std::uint8_t* pixel, const glm::vec4& colour) {
  int largest = 0;
  for (int c = 0; c < 4; ++c)
    largest = std::max(largest, std::abs(pixel[c] - static_cast<int>(255 * colour[c] + 0.5F)));
  return largest;
}

/// Largest difference of a channel between two pixels.
inline int difference(const std::uint8_t* a, const std::uint8_t* b) {
  int largest = 0;
  for (int c = 0; c < 4; ++c) largest = std::max(largest, std::abs(a[c] - b[c]));
  return largest;
}

/// The place of a pixel's colour on viridis, in steps of 0.001.
inline double place_on_viridis(const std::uint8_t* pixel) {
  const glm::vec3 colour(pixel[0] / 255.0F, pixel[1] / 255.0F, pixel[2] / 255.0F);
  double best = 0;
  float nearest = 10;
  for (int step = 0; step <= 1000; ++step) {
    const float t = static_cast<float>(step) / 1000;
    const float distance = glm::distance(colour, viridis(t));
    if (distance < nearest) {
      nearest = distance;
      best = t;
    }
  }
  return best;
}

/// A renderer with a framebuffer off screen; world unit 1 is `pixels_per_unit` pixels and the
/// world's origin is the lower left corner, unless the camera says otherwise.
class Canvas {
 public:
  Canvas(int width, int height, double pixels_per_unit, int samples = 4)
      : screen(width, height, samples) {
    view.viewport = {0, 0, width, height};
    view.camera.centre = glm::dvec2(width, height) / (2 * pixels_per_unit);
    view.camera.pixels_per_unit = pixels_per_unit;
  }

  Image draw(const Snapshot& snapshot, const ViewOptions& options) {
    renderer.draw(snapshot, view, options);
    return screen.read();
  }

  /// The pixel over a world point.
  const std::uint8_t* pixel(const Image& image, double x, double y) const {
    const glm::dvec2 size(image.width, image.height);
    const glm::dvec2 place = world_to_pixel(view.camera, size, {x, y});
    return image.at(static_cast<int>(place.x), static_cast<int>(place.y));
  }

  Offscreen screen;
  SceneRenderer renderer;
  SceneView view;
};

}  // namespace foldless::test
