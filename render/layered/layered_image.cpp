// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/layered/layered_image.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "core/error.h"
#include "core/files/atomic_file.h"
#include "render/layered/layer_formats.h"
#include "render/layered/zip_archive.h"

namespace foldless {
namespace {

constexpr std::string_view kPhotoshopSignature = "8BPS";

/// Premultiplied, 0 … 255 each.
using LightRow = std::vector<std::array<float, 4>>;

void paint_over(LightRow& row, const PictureLayer& layer, int y) {
  const int own_y = y - layer.y;
  if (!layer.is_visible || own_y < 0 || own_y >= layer.image.height) return;
  const int end = std::min(layer.image.width, static_cast<int>(row.size()) - layer.x);
  for (int x = std::max(0, -layer.x); x < end; ++x) {
    const std::uint8_t* pixel = layer.image.at(x, own_y);
    const float alpha = static_cast<float>(layer.opacity) * static_cast<float>(pixel[3]) / 255;
    const int column = layer.x + x;
    auto& below = row[static_cast<std::size_t>(column)];
    for (std::size_t c = 0; c < 4; ++c) {
      const float own = c < 3 ? static_cast<float>(pixel[c]) : 255;
      below[c] = own * alpha + below[c] * (1 - alpha);
    }
  }
}

std::uint8_t to_byte(float value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0F, 255.0F)));
}

}  // namespace

Image composed(const LayeredImage& painting) {
  Image image(painting.width, painting.height);
  for (int y = 0; y < image.height; ++y) {
    LightRow row(static_cast<std::size_t>(image.width), {0, 0, 0, 0});
    for (const PictureLayer& layer : painting.layers) paint_over(row, layer, y);
    for (int x = 0; x < image.width; ++x) {
      const auto& light = row[static_cast<std::size_t>(x)];
      if (light[3] <= 0) continue;
      for (std::size_t c = 0; c < 3; ++c) image.at(x, y)[c] = to_byte(light[c] * 255 / light[3]);
      image.at(x, y)[3] = to_byte(light[3]);
    }
  }
  return image;
}

std::vector<LayerAlpha> layer_alphas(const LayeredImage& painting) {
  std::vector<LayerAlpha> alphas;
  for (const PictureLayer& layer : painting.layers)
    if (layer.is_visible && layer.opacity > 0 && layer.image.width > 0)
      alphas.push_back({layer.name,
                        layer.x,
                        layer.y,
                        {layer.image.width, layer.image.height, alpha_of(layer.image)}});
  return alphas;
}

bool is_layered_file(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension == ".ora" || extension == ".kra" || extension == ".psd";
}

bool is_layered(std::string_view bytes) {
  return is_zip(bytes) || bytes.starts_with(kPhotoshopSignature);
}

LayeredImage decode_layered(std::string_view bytes, LayeredParts parts) {
  if (bytes.starts_with(kPhotoshopSignature)) return decode_photoshop(bytes);
  if (!is_zip(bytes)) throw Error("is not an OpenRaster, Krita or Photoshop file");
  const ZipArchive archive(bytes);
  if (archive.has("stack.xml")) return decode_open_raster(archive, parts);
  if (archive.has("maindoc.xml")) return decode_krita(archive, parts);
  throw Error("is a zip archive, but not of OpenRaster or Krita");
}

LayeredImage load_layered(const std::filesystem::path& file) {
  const std::string bytes = read_file(file);
  try {
    return decode_layered(bytes, LayeredParts::all);
  } catch (const Error& error) {
    throw Error(file.string() + ": " + error.what());
  }
}

}  // namespace foldless
