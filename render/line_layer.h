// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <glm/vec4.hpp>

#include "render/draw_state.h"
#include "render/shader.h"

namespace foldless {

/// How lines look; lengths in design pixels, so that they do not depend on zoom.
struct LineStyle {
  glm::vec4 colour{0, 0, 0, 1};  ///< straight alpha
  float width = 1;
  float dash = 0;        ///< length of dashes and gaps; 0: a solid line
  float fade_below = 0;  ///< shorter segments are fainter, so that dense meshes do not go black
  bool has_round_ends = false;
};

/// Antialiased segments of constant width on screen.
class LineLayer {
 public:
  explicit LineLayer(const std::filesystem::path& shader_folder);

  /// Prepares for glDrawElements or glDrawArrays of GL_LINES with positions in attribute 0.
  void begin(const Frame& frame, const LineStyle& style) const;

 private:
  ShaderProgram program_;
};

}  // namespace foldless
