// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "core/snapshot.h"
#include "render/draw_state.h"
#include "render/line_layer.h"
#include "render/theme.h"

namespace foldless {

/// One marker as it goes to the graphics card; lengths in pixels.
struct Marker {
  glm::vec2 centre;  ///< in the mesh's local frame
  float radius;      ///< half its width, the rim included
  float roundness;   ///< 0 a square … 1 a disc
  float rim_width;
  float shadow;    ///< opacity of the shadow
  glm::vec4 fill;  ///< straight alpha
  glm::vec4 rim;   ///< straight alpha
};

/// What markers are made from.
struct MarkerScene {
  const Snapshot& snapshot;
  const SceneView& view;
  const ViewOptions& options;
  LocalFrame local;  ///< of the mesh on the graphics card
};

/// Points of constant size on screen. A drag handle is a disc, a pin a square, a soft handle a ring
/// that grows with its weight; a target that is not reached is a hollow ring with a dashed line to
/// its vertex.
class MarkerLayer {
 public:
  explicit MarkerLayer(const std::filesystem::path& shader_folder);

  /// Those among the vertices of a sheet.
  void draw_split_vertices(const Frame& frame, const MarkerScene& scene,
                           const std::vector<int>& vertices);
  void draw_handles(const Frame& frame, const MarkerScene& scene, const LineLayer& lines);

 private:
  void draw(const Frame& frame, const std::vector<Marker>& markers) const;
  void draw_segments(const std::vector<glm::vec2>& ends) const;

  ShaderProgram program_;
  Buffer instances_, segments_;
  VertexArray markers_, lines_;
};

}  // namespace foldless
