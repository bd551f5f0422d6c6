// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/layered/merged_image.h"

#include "core/error.h"

namespace foldless {
namespace {

constexpr const char* kMergedName = "mergedimage.png";

}  // namespace

LayeredImage with_merged(const ZipArchive& archive, LayeredParts parts, LayerCollector& layers,
                         const std::function<void()>& read_layers) {
  const bool has_merged = archive.has(kMergedName);
  if (parts == LayeredParts::all || !has_merged) read_layers();
  LayeredImage painting = layers.take();
  if (has_merged) {
    painting.merged = decode_image(archive.read(kMergedName, kMostPixelBytes));
    if (painting.merged.width != painting.width || painting.merged.height != painting.height)
      throw Error(std::string(kMergedName) + " in the archive is not as large as the canvas");
  } else if (painting.layers.empty()) {
    throw Error("there is no merged picture in the archive, and no layer that can be read" +
                (painting.notices.empty() ? "" : "; " + painting.notices.front()));
  } else {
    painting.merged = composed(painting);
  }
  return painting;
}

}  // namespace foldless
