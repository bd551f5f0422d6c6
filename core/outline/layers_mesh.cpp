// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outline/layers_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.h"

namespace foldless {
namespace {

bool has_figure(const AlphaMap& alpha, double threshold) {
  return !alpha.values.empty() && *std::ranges::max_element(alpha.values) >= 255 * threshold;
}

/// With as much of the canvas round it as the outline may take.
LayerAlpha with_room(const LayerAlpha& layer, double margin, const Vec2& canvas) {
  const int room = static_cast<int>(std::min(std::ceil(margin) + 2, canvas.maxCoeff()));
  const int left = std::max(0, layer.x - room), top = std::max(0, layer.y - room);
  const int right = std::min(static_cast<int>(canvas.x()), layer.x + layer.alpha.width + room);
  const int bottom = std::min(static_cast<int>(canvas.y()), layer.y + layer.alpha.height + room);
  LayerAlpha wide{layer.name, left, top, {right - left, bottom - top, {}}};
  wide.alpha.values.resize(static_cast<std::size_t>(right - left) *
                           static_cast<std::size_t>(bottom - top));
  for (int y = 0; y < layer.alpha.height; ++y) {
    const auto from = layer.alpha.values.begin() + static_cast<long>(y) * layer.alpha.width;
    const long row = layer.y - top + y;
    std::copy_n(from, layer.alpha.width,
                wide.alpha.values.begin() + row * wide.alpha.width + layer.x - left);
  }
  return wide;
}

std::optional<ImageMesh> mesh_of_layer(const LayerAlpha& layer, const Vec2& canvas,
                                       const ImageMeshOptions& options,
                                       const std::stop_token& stop) {
  const LayerAlpha wide = with_room(layer, options.margin, canvas);
  try {
    std::optional<ImageMesh> mesh = mesh_of_image(wide.alpha, options, stop);
    if (mesh) mesh->shape.rest.colwise() += Vec2(wide.x, canvas.y() - wide.y - wide.alpha.height);
    return mesh;
  } catch (const Error& error) {
    throw Error("the layer '" + layer.name + "': " + error.what());
  }
}

void take_up(const ImageMesh& layer, ImageMesh& whole) {
  whole.min_angle = whole.parts == 0 ? layer.min_angle : std::min(whole.min_angle, layer.min_angle);
  whole.parts += layer.parts;
  whole.holes += layer.holes;
  whole.specks += layer.specks;
  whole.filled_holes += layer.filled_holes;
  append(layer.shape, whole.shape);
}

}  // namespace

AlphaMap united(std::span<const LayerAlpha> layers, const Vec2& canvas) {
  AlphaMap all{static_cast<int>(canvas.x()), static_cast<int>(canvas.y()), {}};
  all.values.resize(static_cast<std::size_t>(all.width) * static_cast<std::size_t>(all.height));
  for (const LayerAlpha& layer : layers)
    for (int y = 0; y < layer.alpha.height; ++y) {
      const auto row = all.values.begin() + static_cast<long>(layer.y + y) * all.width + layer.x;
      for (int x = 0; x < layer.alpha.width; ++x) row[x] = std::max(row[x], layer.alpha.at(x, y));
    }
  return all;
}

std::optional<LayersMesh> mesh_of_layers(std::span<const LayerAlpha> layers, const Vec2& canvas,
                                         const ImageMeshOptions& options,
                                         const std::stop_token& stop) {
  LayersMesh result;
  for (const LayerAlpha& layer : layers) {
    if (!has_figure(layer.alpha, options.threshold)) {
      result.left_out.push_back(layer.name);
      continue;
    }
    const std::optional<ImageMesh> mesh = mesh_of_layer(layer, canvas, options, stop);
    if (!mesh) return std::nullopt;
    result.parts.push_back({layer.name, static_cast<int>(result.mesh.shape.rest.cols()),
                            static_cast<int>(mesh->shape.rest.cols()),
                            static_cast<double>(result.parts.size())});
    take_up(*mesh, result.mesh);
    if (result.mesh.shape.rest.cols() > kMostImageVertices)
      throw Error("the meshes of the layers would have more than " +
                  std::to_string(kMostImageVertices) + " vertices; allow longer edges");
  }
  if (result.parts.empty())
    throw Error(
        "the layers are transparent everywhere; choose another image, or lower the "
        "threshold");
  return result;
}

}  // namespace foldless
