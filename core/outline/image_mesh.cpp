// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outline/image_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "core/error.h"
#include "core/mesh/quality.h"
#include "core/outline/loops.h"
#include "core/outline/regions.h"
#include "core/outline/triangulate.h"

namespace foldless {
namespace {

double vertices_for(MeshDetail detail) {
  switch (detail) {
    case MeshDetail::coarse: return 500;
    case MeshDetail::fine: return 8000;
    case MeshDetail::medium: break;
  }
  return 2000;
}

/// Two digits: these numbers are shown.
double rounded_to_two_digits(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return std::round(value / unit) * unit;
}

double figure_area(const AlphaMap& alpha, double threshold) {
  const auto level = static_cast<std::uint8_t>(std::ceil(255 * threshold));
  return static_cast<double>(
      std::ranges::count_if(alpha.values, [level](std::uint8_t a) { return a >= level; }));
}

/// Speck sizes follow the picture as the margin does.
double speck_area(const AlphaMap& alpha) {
  return std::max(16.0, 1e-5 * static_cast<double>(alpha.width) * alpha.height);
}

/// Refuses at once what would have too many vertices: a triangle has an area of at most √3/4 of the
/// square of its longest edge, and a mesh with a boundary more vertices than half its triangles.
void check_size(const Regions& regions, double edge_length) {
  double area = 0, holes = 0;
  for (const Outline& outline : regions.outlines) {
    area += area_of(outline.boundary);
    for (const Loop& hole : outline.holes) area += area_of(hole);
    holes += static_cast<double>(outline.holes.size());
  }
  const double triangles = area / (0.25 * std::numbers::sqrt3 * edge_length * edge_length);
  if (0.5 * triangles - holes > kMostImageVertices)
    throw Error("the mesh would have more than " + std::to_string(kMostImageVertices) +
                " vertices; allow longer edges");
}

}  // namespace

ImageMeshOptions options_for(const AlphaMap& alpha, MeshDetail detail) {
  ImageMeshOptions options;
  const double side = std::sqrt(static_cast<double>(alpha.width) * alpha.height);
  const double area = std::max(figure_area(alpha, options.threshold), 1.0);
  options.simplify = rounded_to_two_digits(std::min(std::max(0.75, side / 1000), side / 20));
  options.margin = rounded_to_two_digits(std::min(std::max(2.0, 2 * options.simplify), side));
  options.edge_length =
      rounded_to_two_digits(std::max(1.0, 1.6 * std::sqrt(area / vertices_for(detail))));
  return options;
}

std::optional<ImageMesh> mesh_of_image(const AlphaMap& alpha, const ImageMeshOptions& options,
                                       const std::stop_token& stop) {
  if (!(options.edge_length > 0))
    throw Error("the edge length of a mesh must be a positive number");
  const Regions regions = regions_of(
      alpha, {options.threshold, options.margin, options.simplify, speck_area(alpha)}, stop);
  check_size(regions, options.edge_length);
  ImageMesh mesh;
  for (const Outline& outline : regions.outlines) {
    const int left = kMostImageVertices - static_cast<int>(mesh.shape.rest.cols());
    append(triangulate(outline, {options.edge_length, options.min_angle, left, stop}), mesh.shape);
    mesh.holes += static_cast<int>(outline.holes.size());
    if (stop.stop_requested()) return std::nullopt;
  }
  if (stop.stop_requested()) return std::nullopt;
  mesh.parts = static_cast<int>(regions.outlines.size());
  mesh.specks = regions.specks;
  mesh.filled_holes = regions.filled_holes;
  mesh.min_angle = smallest_angle(mesh.shape);
  return mesh;
}

}  // namespace foldless
