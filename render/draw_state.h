// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "render/camera.h"
#include "render/scene_renderer.h"
#include "render/shader.h"

namespace foldless {

/// What every layer of a frame shares.
struct Frame {
  ClipTransform clip;     ///< from positions in the mesh's local frame
  glm::vec2 viewport{1};  ///< pixels
  float ui_scale = 1;     ///< pixels in one design pixel
};

/// Makes the program current and sets `clip_scale`, `clip_offset`, `viewport` and `ui_scale`.
void use_in_frame(const ShaderProgram& program, const Frame& frame);

/// The GL state that the layers draw in, for as long as it lives: the viewport and a scissor on it,
/// premultiplied blending, no depth, stencil or face culling. Leaves everything off and unbound.
class DrawState {
 public:
  explicit DrawState(const Viewport& viewport);
  ~DrawState();
  DrawState(const DrawState&) = delete;
  DrawState& operator=(const DrawState&) = delete;
};

/// Draws over what is there, for as long as it lives: with colours that hide it, which need not be
/// mixed with it (for a software rasteriser a tenth of a frame). Blending is on before and after.
class NoBlending {
 public:
  NoBlending();
  ~NoBlending();
  NoBlending(const NoBlending&) = delete;
  NoBlending& operator=(const NoBlending&) = delete;
};

/// Fills the viewport of the DrawState; `colour` has straight alpha.
void clear_canvas(const glm::vec4& colour);

}  // namespace foldless
