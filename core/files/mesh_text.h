// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/mesh/triangle.h"

namespace foldless {

/// A mesh as the text of a file. Every number is the shortest one that reads back exactly; z is 0.

/// Wavefront OBJ. With `rest` (2 × #V) every vertex has the texture coordinates of its rest
/// position: moved and scaled, the same in x and y, into [0, 1]².
std::string obj_text(const Triangles& triangles, const Points& points,
                     const Points* rest = nullptr);

/// The two halves of obj_text(). Meshes that differ in positions alone share the second, which is
/// three quarters of a large file.
std::string obj_vertex_lines(const Points& points);
std::string obj_lines_after_vertices(const Triangles& triangles, const Points* rest);

/// Wavefront OBJ with these texture coordinates, 2 × #V.
std::string textured_obj_text(const Triangles& triangles, const Points& points,
                              const Points& coordinates);

/// Geomview OFF.
std::string off_text(const Triangles& triangles, const Points& points);

/// PLY of format ascii with double coordinates.
std::string ply_text(const Triangles& triangles, const Points& points);

}  // namespace foldless
