// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "core/files/polygon_soup.h"
#include "core/mesh/triangle.h"

namespace foldless {

/// What the text of a mesh file says, unchecked but for being readable. `name` is the file for
/// messages. They throw Error `NAME:LINE: ...` for what cannot be read, a number above all.

/// Wavefront OBJ: v (further numbers such as colours are ignored) and f, with indices from the
/// front or from the back, v, v/vt, v//vn or v/vt/vn; lines continued by \; all else is ignored.
PolygonSoup read_obj(std::string_view text, std::string name);

/// The texture coordinates (vt u v) that the corners of the faces of an OBJ give to its vertices,
/// not numbers at a vertex that has none. Throws Error `NAME:LINE: ...` for what cannot be read,
/// for a number of none of them, and for a vertex that has two. Precondition: planar_triangles()
/// took what read_obj() made of the text.
Points read_obj_texture(std::string_view text, std::string_view name);

/// Geomview OFF as text, with or without its header word; numbers that follow the first three of
/// a vertex or the corners of a face are ignored.
PolygonSoup read_off(std::string_view text, std::string name);

/// PLY, text or binary, coordinates in float or double, through CGAL's reader.
PolygonSoup read_ply(std::string_view bytes, std::string name);

}  // namespace foldless
