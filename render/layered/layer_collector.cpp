// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/layered/layer_collector.h"

#include <algorithm>
#include <set>

#include "core/error.h"

namespace foldless {
namespace {

constexpr std::size_t kMostLayers = 1000;
constexpr std::size_t kMostLayerPixels = 100'000'000;
constexpr std::size_t kNamesOfANote = 3;

/// Columns and rows, one past the last at the end.
struct PixelRange {
  int left, top, right, bottom;

  bool is_empty() const { return left >= right || top >= bottom; }
};

/// The pixels of a layer that lie on the canvas; a file may say that it lies anywhere.
PixelRange pixels_on_canvas(const PictureLayer& layer, int width, int height) {
  const auto cut = [](long place, int most) {
    return static_cast<int>(std::clamp<long>(place, 0, most));
  };
  const long x = layer.x, y = layer.y;
  return {cut(-x, layer.image.width), cut(-y, layer.image.height),
          cut(width - x, layer.image.width), cut(height - y, layer.image.height)};
}

PixelRange seen_pixels(const PictureLayer& layer, int width, int height) {
  const PixelRange on_canvas = pixels_on_canvas(layer, width, height);
  if (on_canvas.is_empty()) return {};
  PixelRange seen{on_canvas.right, on_canvas.bottom, on_canvas.left, on_canvas.top};
  for (int y = on_canvas.top; y < on_canvas.bottom; ++y)
    for (int x = on_canvas.left; x < on_canvas.right; ++x)
      if (layer.image.at(x, y)[3] > 0)
        seen = {std::min(seen.left, x), std::min(seen.top, y), std::max(seen.right, x + 1),
                std::max(seen.bottom, y + 1)};
  return seen;
}

void cut_down(PictureLayer& layer, int width, int height) {
  const PixelRange seen = seen_pixels(layer, width, height);
  if (seen.is_empty()) {
    layer.image = {};
    layer.x = layer.y = 0;
    return;
  }
  Image part(seen.right - seen.left, seen.bottom - seen.top);
  for (int y = 0; y < part.height; ++y)
    std::copy_n(layer.image.at(seen.left, seen.top + y), 4 * part.width, part.at(0, y));
  layer.image = std::move(part);
  layer.x += seen.left;
  layer.y += seen.top;
}

/// "Arm", "Arm (2)", "Arm (3)" from the bottom up.
void tell_apart(std::vector<PictureLayer>& layers) {
  std::set<std::string> taken;
  for (PictureLayer& layer : layers) {
    const std::string name = layer.name.empty() ? "Layer" : layer.name;
    layer.name = name;
    for (int number = 2; !taken.insert(layer.name).second; ++number) {
      layer.name = name;
      layer.name += " (" + std::to_string(number) + ")";
    }
  }
}

std::string sentence_of(const std::string& what, const std::vector<std::string>& layers) {
  std::string names;
  for (std::size_t i = 0; i < std::min(layers.size(), kNamesOfANote); ++i)
    names += (i > 0 ? ", " : "") + layers[i];
  if (layers.size() > kNamesOfANote)
    names += " and " + std::to_string(layers.size() - kNamesOfANote) + " more";
  return what + ": " + names;
}

}  // namespace

LayerCollector::LayerCollector(long width, long height) {
  check_image_size(width, height);
  painting_.width = static_cast<int>(width);
  painting_.height = static_cast<int>(height);
}

void LayerCollector::add(PictureLayer layer) {
  if (has_given_up()) return;
  if (painting_.layers.size() == kMostLayers)
    return give_up("The file has more than " + std::to_string(kMostLayers) +
                   " layers: they are only read merged");
  cut_down(layer, painting_.width, painting_.height);
  pixels_ += layer.image.pixels.size() / 4;
  if (pixels_ > kMostLayerPixels)
    return give_up("The layers have more than " + std::to_string(kMostLayerPixels) +
                   " pixels in all: they are only read merged");
  painting_.layers.push_back(std::move(layer));
}

void LayerCollector::note(const std::string& what, const std::string& layer) {
  auto it = std::ranges::find(notes_, what, [](const auto& note) { return note.first; });
  if (it == notes_.end()) it = notes_.insert(notes_.end(), {what, {}});
  it->second.push_back(layer);
}

void LayerCollector::give_up(std::string why) {
  reason_ = std::move(why);
  painting_.layers.clear();
}

LayeredImage LayerCollector::take() {
  if (reason_.empty()) {
    std::ranges::reverse(painting_.layers);
    tell_apart(painting_.layers);
    for (const auto& [what, layers] : notes_)
      painting_.notices.push_back(sentence_of(what, layers));
  } else {
    painting_.notices = {reason_};
  }
  return std::move(painting_);
}

}  // namespace foldless
