// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/gl_objects.h"
#include "render/texture_levels.h"

namespace foldless {

/// An image on the graphics card with all its levels.
class FillTexture {
 public:
  /// What is seen beyond the edges of the image.
  enum class Beyond { edge, nothing };

  /// Throws Error when the image is empty or larger than the graphics card takes.
  explicit FillTexture(const TextureLevels& levels, Beyond beyond = Beyond::edge);

  void bind() const { glBindTexture(GL_TEXTURE_2D, texture_.id()); }

 private:
  Texture texture_;
};

}  // namespace foldless
