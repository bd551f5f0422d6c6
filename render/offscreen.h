// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "render/image.h"

namespace foldless {

/// A GL 3.3 context without window, display or graphics card, and a framebuffer in it. One thread
/// at a time; while it is current, GL calls of this process go to it.
class Offscreen {
 public:
  /// Makes the context current, loads the GL functions, binds the framebuffer. Throws Error when
  /// the context is refused.
  Offscreen(int width, int height, int samples = 4);
  ~Offscreen();
  Offscreen(const Offscreen&) = delete;
  Offscreen& operator=(const Offscreen&) = delete;

  /// Makes the context current again after another one was, and loads its GL functions.
  void make_current();
  /// Binds the framebuffer, with a viewport over all of it.
  void bind();
  /// A new framebuffer of another size, bound.
  void resize(int width, int height);

  int width() const;
  int height() const;
  int samples() const;  ///< samples a pixel in fact; 1 means no multisampling

  /// The pixels, samples resolved, straight alpha.
  Image read();

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

}  // namespace foldless
