// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/mesh/triangle.h"

namespace foldless {

/// A part of a mesh that shows one layer of a painting: whole components, which flips and splits
/// keep apart from those of other parts.
struct MeshPart {
  std::string layer;     ///< its name in the file of the texture
  int first_vertex = 0;  ///< of the original mesh
  int vertices = 0;      ///< of the original mesh, from the first on
  double depth = 0;      ///< that of handles is added; the larger is in front

  bool operator==(const MeshPart&) const = default;
};

/// All parts of a mesh: their vertices follow one another, from the first of the mesh to its last.
using MeshParts = std::vector<MeshPart>;

/// For every triangle the part that its component belongs to; all 0 where there are no parts.
/// Precondition: original vertices come first, and every component has one.
std::vector<int> parts_of_triangles(const Triangles& triangles, int vertices,
                                    std::span<const MeshPart> parts);

}  // namespace foldless
