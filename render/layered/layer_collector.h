// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "render/layered/layered_image.h"

namespace foldless {

/// Gathers the layers of a file from the top one down, within its limits.
class LayerCollector {
 public:
  /// Throws Error as check_image_size(), which sees the size of the canvas.
  LayerCollector(long width, long height);

  int width() const { return painting_.width; }
  int height() const { return painting_.height; }

  /// Takes a layer anywhere on or off the canvas and cuts it down. Gives up at too many layers or
  /// pixels in all.
  void add(PictureLayer layer);
  /// Something of a layer that is not kept, e.g. "masks are left out".
  void note(const std::string& what, const std::string& layer);
  /// The layers cannot be had, only the merged picture, and why: a sentence. Those that were taken
  /// go, and no more are wanted.
  void give_up(std::string why);
  bool has_given_up() const { return !reason_.empty(); }

  /// The painting, all but its merged picture: layers bottom to top, each with a name of its own.
  LayeredImage take();

 private:
  LayeredImage painting_;
  std::size_t pixels_ = 0;
  std::vector<std::pair<std::string, std::vector<std::string>>> notes_;  ///< layers by what
  std::string reason_;
};

}  // namespace foldless
