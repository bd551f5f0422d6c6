// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>

#include "render/gl_objects.h"
#include "render/texture_levels.h"

namespace foldless {

/// An image on the graphics card with all its levels. They come there from the coarsest on, as much
/// at a time as is asked for: what is there already is seen.
class FillTexture {
 public:
  /// What is seen beyond the edges of the image.
  enum class Beyond { edge, nothing };

  /// Makes room and brings the coarsest level. Throws Error when the image is empty or larger than
  /// the graphics card takes.
  explicit FillTexture(std::shared_ptr<const TextureLevels> levels, Beyond beyond = Beyond::edge);

  void bind() const { glBindTexture(GL_TEXTURE_2D, texture_.id()); }

  /// Brings at least a row, at most about so many pixels; returns how many.
  std::size_t upload(std::size_t pixels);
  bool is_whole() const { return !levels_; }

 private:
  void upload_rows(int rows);

  Texture texture_;
  std::shared_ptr<const TextureLevels> levels_;  ///< null once all are there
  std::size_t level_ = 0;                        ///< that is brought
  int rows_ = 0;                                 ///< of it that are there
};

}  // namespace foldless
