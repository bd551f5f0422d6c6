// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/gltf_pieces.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/export/texture_place.h"
#include "core/mesh/parts.h"
#include "render/theme.h"
#include "render/view_options.h"

namespace foldless {
namespace {

Box rest_box(const Scene& scene) {
  const Vec2 min = scene.rest.rowwise().minCoeff(), max = scene.rest.rowwise().maxCoeff();
  return {{min.x(), min.y()}, {max.x(), max.y()}};
}

void paint(std::uint8_t* pixel, const glm::vec4& colour) {
  for (int k = 0; k < 4; ++k) pixel[k] = static_cast<std::uint8_t>(std::lround(255 * colour[k]));
}

/// Four squares of the checkerboard, which are repeated.
GltfPiece checkerboard(const Scene& scene) {
  const CanvasColours& colours = canvas_colours(Theme::light);
  GltfPiece piece;
  piece.image = Image(2, 2);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 2; ++x)
      paint(piece.image.at(x, y), x == y ? colours.checker_dark : colours.checker_light);
  const Box box = rest_box(scene);
  const double squares =
      std::max(box.max.x - box.min.x, box.max.y - box.min.y) / ViewOptions().checker_squares;
  piece.place = {box.min, box.min + 2 * squares};
  piece.is_tiled = true;
  return piece;
}

/// Straight alpha again.
Image unmultiplied(Image image) {
  for (std::size_t p = 0; p < image.pixels.size(); p += 4) {
    const int alpha = image.pixels[p + 3];
    if (alpha == 0) continue;
    for (std::size_t k = 0; k < 3; ++k)
      image.pixels[p + k] =
          static_cast<std::uint8_t>(std::min(255, (255 * image.pixels[p + k] + alpha / 2) / alpha));
  }
  return image;
}

/// The depth of a piece counts by its place among the others.
void order_by_depth(const Scene& scene, std::vector<std::pair<double, GltfPiece>>& pieces) {
  std::ranges::stable_sort(pieces, {}, [](const auto& piece) { return piece.first; });
  const Box box = rest_box(scene);
  const double step = 1e-4 * std::max(box.max.x - box.min.x, box.max.y - box.min.y);
  for (std::size_t i = 0; i < pieces.size(); ++i)
    pieces[i].second.z = step * static_cast<double>(i);
}

}  // namespace

std::vector<GltfPiece> gltf_pieces(const Scene& scene, const BakedAnimation& animation,
                                   const std::shared_ptr<const TexturePieces>& texture) {
  const MeshParts parts = scene.parts ? *scene.parts : MeshParts();
  const std::vector<int> part_of =
      parts_of_triangles(animation.triangles, static_cast<int>(animation.rest.cols()), parts);
  const std::size_t count = texture ? texture->size() : 1;
  std::vector<std::pair<double, GltfPiece>> pieces;
  for (std::size_t k = 0; k < count; ++k) {
    GltfPiece piece = texture ? GltfPiece() : checkerboard(scene);
    if (texture) {
      const TexturePiece& shown = (*texture)[k];
      if (!shown.levels || shown.levels->empty()) continue;
      piece.image = unmultiplied(shown.levels->front());
      const Box whole = texture_place(scene).value_or(rest_box(scene));
      const auto size = whole.max - whole.min;
      piece.place = {whole.min + shown.within.min * size, whole.min + shown.within.max * size};
    }
    for (std::size_t t = 0; t < part_of.size(); ++t)
      if (count == 1 || part_of[t] == static_cast<int>(k))
        piece.triangles.push_back(static_cast<int>(t));
    if (piece.triangles.empty()) continue;
    pieces.emplace_back(count > 1 ? parts[k].depth : 0.0, std::move(piece));
  }
  order_by_depth(scene, pieces);
  std::vector<GltfPiece> result;
  result.reserve(pieces.size());
  for (auto& piece : pieces) result.push_back(std::move(piece.second));
  return result;
}

}  // namespace foldless
