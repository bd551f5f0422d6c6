// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "render/image.h"

namespace foldless {

/// A framebuffer of its own, multisampled where the context can, for pictures of any size: bind(),
/// draw, read(). Every function needs the context of the constructor to be current.
class RenderTarget {
 public:
  /// Sizes in pixels, ≥ 1. Takes fewer samples, down to 1, when the context refuses. Throws Error
  /// when the context cannot make a framebuffer of this size at all.
  RenderTarget(int width, int height, int samples = 4);
  ~RenderTarget();
  RenderTarget(RenderTarget&&) noexcept;
  RenderTarget& operator=(RenderTarget&&) noexcept;

  int width() const;
  int height() const;
  /// Samples a pixel in fact; 1 means no multisampling.
  int samples() const;

  /// Makes it the framebuffer that is drawn into, with a viewport over all of it.
  void bind();
  /// Resolves the samples and reads the pixels back; alpha becomes straight. Leaves the target
  /// bound.
  Image read();

 private:
  struct Buffers;
  std::unique_ptr<Buffers> buffers_;
};

}  // namespace foldless
