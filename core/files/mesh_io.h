// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/mesh/triangle.h"

namespace foldless {

/// A planar triangle mesh from a file. Indices are those of the file, counted from 0.
struct LoadedMesh {
  Triangles triangles;               ///< 3 × #F
  Points points;                     ///< 2 × #V
  std::vector<std::string> notices;  ///< what was repaired, one sentence each
};

/// True for the names that read_mesh() and write_mesh() take: .obj, .off and .ply in any case.
bool is_mesh_file(const std::filesystem::path& file);

/// Reads a mesh that the solver can take: oriented, manifold, locally injective. Repairs what can
/// be repaired and tells so in the notices. Throws Error (see planar_triangles() and validated())
/// for all else. Doubles are read exactly, whatever the locale.
LoadedMesh read_mesh(const std::filesystem::path& file);

/// Reads a mesh whose positions are still to be judged: as read_mesh(), but triangles may be
/// clockwise, of zero area or cover a vertex more than once, and none is turned over.
LoadedMesh read_mesh_of_any_shape(const std::filesystem::path& file);

/// Writes a mesh atomically, in the format of the file's extension; see mesh_text.h. `rest`, if
/// given, becomes the texture coordinates of an OBJ file. Throws Error.
void write_mesh(const std::filesystem::path& file, const Triangles& triangles, const Points& points,
                const Points* rest = nullptr);

}  // namespace foldless
