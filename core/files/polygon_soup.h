// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "core/files/mesh_source.h"
#include "core/mesh/triangle.h"

namespace foldless {

/// A mesh as its file has it, before anything is checked.
struct PolygonSoup {
  MeshSource source;
  std::vector<std::array<double, 3>> vertices;
  std::vector<int> corners;         ///< vertex indices from 0 of all faces, one after the other
  std::vector<std::size_t> ends{};  ///< end of each face in `corners`

  int face_count() const { return static_cast<int>(ends.size()); }
  std::span<const int> face(int f) const;
  void end_face() { ends.push_back(corners.size()); }
};

/// A planar mesh of triangles; what was changed on the way is told in `notices`.
struct TriangleSoup {
  Triangles triangles;  ///< 3 × #F
  Points points;        ///< 2 × #V
  MeshSource source;
  std::vector<std::string> notices;  ///< one sentence each
};

/// Checks numbers and faces one by one, drops the constant z, and cuts polygons into triangles.
/// Throws Error for a coordinate that is not finite, an index out of range, an index that a face
/// repeats, no faces, z that varies, and a polygon that crosses itself.
TriangleSoup planar_triangles(PolygonSoup soup);

}  // namespace foldless
