// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "core/snapshot.h"
#include "render/camera.h"
#include "render/line_style.h"
#include "render/scene_renderer.h"
#include "render/view_options.h"

namespace foldless {

/// One marker as it goes to the graphics card, a point of constant size on screen; lengths in
/// pixels.
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

/// The markers of the handles, from back to front: lines, targets, handles.
struct HandleMarkers {
  LineStyle line_style;
  std::vector<glm::vec2> line_ends;  ///< in the local frame, two a line
  std::vector<Marker> targets, handles;
};

/// A drag handle is a disc, a pin a square, a soft handle a ring that grows with its weight; a
/// target that is not reached is a hollow ring with a dashed line to its vertex.
HandleMarkers handle_markers(const MarkerScene& scene);

/// The vertices made by splits among those given.
std::vector<Marker> split_markers(const MarkerScene& scene, const std::vector<int>& vertices);

}  // namespace foldless
