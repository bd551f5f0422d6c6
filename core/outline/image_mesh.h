// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <stop_token>

#include "core/mesh/shape.h"
#include "core/outline/alpha_map.h"

namespace foldless {

/// How a picture becomes a mesh; lengths in its pixels.
struct ImageMeshOptions {
  double threshold = 0.1;   ///< alpha, 0 … 1, from which on a pixel belongs to the figure; > 0
  double margin = 2;        ///< that the outline keeps away from the figure
  double simplify = 1;      ///< by which corners of the outline that are left out may be off
  double edge_length = 20;  ///< no edge is longer
  double min_angle = 20.7;  ///< degrees, 0 … 33; sharp corners of the outline have smaller ones

  bool operator==(const ImageMeshOptions&) const = default;
};

/// About 500, 2,000 and 8,000 vertices.
enum class MeshDetail { coarse, medium, fine };

/// Options that suit the size of the picture and of its figure.
ImageMeshOptions options_for(const AlphaMap& alpha, MeshDetail detail = MeshDetail::medium);

/// The mesh of a picture's figure.
struct ImageMesh {
  Shape shape;  ///< in pixels, the lower left corner of the picture at (0, 0), y up
  int parts = 0;
  int holes = 0;
  int specks = 0;  ///< parts of a few pixels that were left out
  int filled_holes = 0;
  double min_angle = 0;  ///< of all triangles, degrees
};

/// Of the mesh of a picture.
inline constexpr int kMostImageVertices = 200'000;

/// Meshes what of a picture is opaque: outline with margin, several parts, holes; the mesh stays
/// within the picture. The same input always gives the same mesh. Nothing if `stop` was requested
/// before it was done. Throws Error as regions_of() and triangulate(), and on more than 200,000
/// vertices.
std::optional<ImageMesh> mesh_of_image(const AlphaMap& alpha, const ImageMeshOptions& options,
                                       const std::stop_token& stop = {});

}  // namespace foldless
