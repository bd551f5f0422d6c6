// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/scene/scene.h"
#include "render/camera.h"

namespace foldless {

/// Where a scene's texture lies, for the renderer.
inline std::optional<Box> texture_place(const Scene& scene) {
  if (!scene.texture_box) return std::nullopt;
  const auto& [min, max] = *scene.texture_box;
  return Box{{min.x(), min.y()}, {max.x(), max.y()}};
}

}  // namespace foldless
