// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/texture_pieces.h"

#include <cmath>
#include <utility>

namespace foldless {
namespace {

Image faded(Image image, double opacity) {
  for (std::size_t p = 3; p < image.pixels.size(); p += 4)
    image.pixels[p] = static_cast<std::uint8_t>(std::lround(image.pixels[p] * opacity));
  return image;
}

}  // namespace

std::shared_ptr<const TexturePieces> whole_texture(Image image) {
  auto levels = std::make_shared<const TextureLevels>(texture_levels(std::move(image)));
  return std::make_shared<const TexturePieces>(TexturePieces{{std::move(levels), Box{}}});
}

LayerPieces layer_pieces(LayeredImage painting) {
  LayerPieces pieces;
  const glm::dvec2 canvas(painting.width, painting.height);
  for (PictureLayer& layer : painting.layers) {
    TexturePiece piece;
    const glm::dvec2 upper_left(layer.x, painting.height - layer.y);
    const glm::dvec2 size(layer.image.width, layer.image.height);
    piece.within = {glm::dvec2(upper_left.x, upper_left.y - size.y) / canvas,
                    glm::dvec2(upper_left.x + size.x, upper_left.y) / canvas};
    if (layer.image.width > 0)
      piece.levels = std::make_shared<const TextureLevels>(
          texture_levels(faded(std::move(layer.image), layer.opacity)));
    pieces.emplace(std::move(layer.name), std::move(piece));
  }
  return pieces;
}

std::shared_ptr<const TexturePieces> pieces_for(const MeshParts& parts, const LayerPieces& layers) {
  auto pieces = std::make_shared<TexturePieces>();
  for (const MeshPart& part : parts) {
    const auto found = layers.find(part.layer);
    pieces->push_back(found == layers.end() ? TexturePiece{} : found->second);
  }
  return pieces;
}

LoadedTexture load_texture(const std::filesystem::path& file, const MeshParts* parts) {
  if (!parts || !is_layered_file(file)) return {whole_texture(load_image(file)), {}};
  LayeredImage painting = load_layered(file);
  if (painting.layers.empty())
    return {whole_texture(std::move(painting.merged)), std::move(painting.notices)};
  LoadedTexture texture;
  const LayerPieces layers = layer_pieces(std::move(painting));
  for (const MeshPart& part : *parts)
    if (!layers.contains(part.layer))
      texture.notices.push_back(file.filename().string() + " has no layer '" + part.layer +
                                "' any more: its part is not seen");
  texture.pieces = pieces_for(*parts, layers);
  return texture;
}

}  // namespace foldless
