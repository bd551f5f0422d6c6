// SPDX-License-Identifier: GPL-3.0-or-later
// A second opinion on whether a mesh is locally injective. It shares no code with the program,
// neither predicates nor readers. What doubles, with a bound on how far they may be off, leave open
// it decides with rationals.
#pragma once

#include <array>
#include <istream>
#include <string>
#include <vector>

namespace judge {

using Point = std::array<double, 2>;
using Triangle = std::array<int, 3>;

struct Mesh {
  std::vector<Point> points;
  std::vector<Triangle> triangles;
};

/// What is wrong with a mesh, one sentence each; none when it is locally injective:
///   - every coordinate is finite, every triangle is counter-clockwise and has an area;
///   - no edge has more than two triangles, and the triangles of a vertex form one fan;
///   - the triangles round an interior vertex go round it once;
///   - the angles at a boundary vertex add up to less than 2π.
std::vector<std::string> objections_to(const Mesh& mesh);

/// The vertices and triangles of an OBJ file; z is left out. Throws std::runtime_error for what is
/// no triangle mesh.
Mesh read_obj(std::istream& in);

}  // namespace judge
