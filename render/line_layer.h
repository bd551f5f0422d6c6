// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "render/draw_state.h"
#include "render/line_style.h"
#include "render/shader.h"

namespace foldless {

/// Antialiased segments of constant width on screen. They do not fade: that is for WireLayer.
class LineLayer {
 public:
  explicit LineLayer(const std::filesystem::path& shader_folder);

  /// Prepares for glDrawElements or glDrawArrays of GL_LINES with positions in attribute 0.
  void begin(const Frame& frame, const LineStyle& style) const;

 private:
  ShaderProgram program_;
};

}  // namespace foldless
