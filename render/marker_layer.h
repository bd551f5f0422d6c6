// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <vector>

#include "render/draw_state.h"
#include "render/line_layer.h"
#include "render/markers.h"

namespace foldless {

/// Draws markers.
class MarkerLayer {
 public:
  explicit MarkerLayer(const std::filesystem::path& shader_folder);

  /// See split_markers().
  void draw_split_vertices(const Frame& frame, const MarkerScene& scene,
                           const std::vector<int>& vertices) const;
  /// See handle_markers().
  void draw_handles(const Frame& frame, const MarkerScene& scene, const LineLayer& lines) const;

 private:
  void draw(const Frame& frame, const std::vector<Marker>& markers) const;
  void draw_segments(const std::vector<glm::vec2>& ends) const;

  ShaderProgram program_;
  Buffer instances_, segments_;
  VertexArray markers_, lines_;
};

}  // namespace foldless
