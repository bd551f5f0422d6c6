// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/camera.h"

#include <algorithm>
#include <limits>

namespace foldless {
namespace {

constexpr double kMinScale = 1e-120;
constexpr double kMaxScale = 1e120;
constexpr glm::dvec2 kDown{1, -1};  // pixels count y downwards

}  // namespace

glm::dvec2 world_to_pixel(const Camera& camera, glm::dvec2 viewport, glm::dvec2 world) {
  return 0.5 * viewport + camera.pixels_per_unit * kDown * (world - camera.centre);
}

glm::dvec2 pixel_to_world(const Camera& camera, glm::dvec2 viewport, glm::dvec2 pixel) {
  return camera.centre + kDown * (pixel - 0.5 * viewport) / camera.pixels_per_unit;
}

Camera zoomed_about(const Camera& camera, glm::dvec2 viewport, glm::dvec2 pixel, double factor) {
  Camera zoomed = camera;
  zoomed.pixels_per_unit = std::clamp(camera.pixels_per_unit * factor, kMinScale, kMaxScale);
  const glm::dvec2 kept = pixel_to_world(camera, viewport, pixel);
  zoomed.centre += kept - pixel_to_world(zoomed, viewport, pixel);
  return zoomed;
}

Camera panned(const Camera& camera, glm::dvec2 pixels) {
  return {camera.centre - kDown * pixels / camera.pixels_per_unit, camera.pixels_per_unit};
}

Camera fit_to_box(const Box& box, glm::dvec2 viewport, double margin) {
  const glm::dvec2 extent = box.max - box.min;
  double scale = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 2; ++axis) {
    const double room = std::max(viewport[axis] - 2 * margin, 0.5 * viewport[axis]);
    if (extent[axis] > 0) scale = std::min(scale, room / extent[axis]);
  }
  const bool is_point = scale == std::numeric_limits<double>::infinity();
  return {0.5 * (box.min + box.max), is_point ? 100 : std::clamp(scale, kMinScale, kMaxScale)};
}

ClipTransform clip_transform(const Camera& camera, glm::dvec2 viewport, const LocalFrame& local) {
  const glm::dvec2 scale = 2 * camera.pixels_per_unit / viewport;
  return {scale * local.unit, scale * (local.origin - camera.centre)};
}

}  // namespace foldless
