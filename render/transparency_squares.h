// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "render/camera.h"
#include "render/gl_objects.h"
#include "render/shader.h"
#include "render/view_options.h"
#include "render/viewport.h"

namespace foldless {

/// The grey squares that programs show where a picture is transparent.
class TransparencySquares {
 public:
  explicit TransparencySquares(const std::filesystem::path& shader_folder = {});

  /// From where the picture is seen.
  struct Place {
    Viewport viewport;
    Camera camera;
    double ui_scale = 1;  ///< framebuffer pixels in a design pixel
  };
  /// Fills a box of the plane with squares of the screen's size. Precondition: as that of
  /// SceneRenderer::draw(), before which it is called.
  void draw(const Box& box, const Place& place, Theme theme) const;

 private:
  ShaderProgram program_;
  VertexArray nothing_;  ///< the shader makes the corners
};

}  // namespace foldless
