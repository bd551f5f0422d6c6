// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/prescribed_regions.h"

#include <algorithm>
#include <set>

#include "core/mesh/boundary.h"
#include "core/mesh/components.h"
#include "core/mesh/injective.h"

namespace foldless {
namespace {

constexpr int kNone = -1;

/// What there is of each vertex.
struct VertexMarks {
  std::vector<int> handle;     ///< the one that is not soft, or kNone
  std::vector<int> component;  ///< the vertex that stands for it
  std::vector<bool> interior;
};

std::size_t at(int index) { return static_cast<std::size_t>(index); }

VertexMarks marks_of(const MeshPair& mesh, const Constraints& constraints,
                     const std::vector<BoundaryNeighbours>& neighbours) {
  VertexMarks marks{std::vector<int>(at(mesh.vertex_count()), kNone),
                    components_of(mesh.triangles(), mesh.vertex_count()),
                    interior_vertices(mesh.triangles(), neighbours)};
  for (int i = 0; i < constraints.count(); ++i)
    if (!constraints.soft[at(i)]) marks.handle[at(constraints.vertices[at(i)])] = i;
  return marks;
}

/// The vertices of every component whose whole boundary is prescribed.
std::vector<std::vector<int>> prescribed_components(const MeshPair& mesh,
                                                    const VertexMarks& marks) {
  std::vector<bool> is_prescribed(marks.component.size(), true);
  for (int v = 0; v < mesh.vertex_count(); ++v)
    if (!marks.interior[at(v)] && marks.handle[at(v)] == kNone)
      is_prescribed[at(marks.component[at(v)])] = false;
  std::vector<std::vector<int>> prescribed;
  std::vector<int> place(marks.component.size(), kNone);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const int component = marks.component[at(v)];
    if (!is_prescribed[at(component)]) continue;
    if (place[at(component)] == kNone) {
      place[at(component)] = static_cast<int>(prescribed.size());
      prescribed.emplace_back();
    }
    prescribed[at(place[at(component)])].push_back(v);
  }
  return prescribed;
}

PrescribedRegion region_of(const MeshPair& mesh, const VertexMarks& marks,
                           const std::vector<BoundaryNeighbours>& neighbours,
                           const std::vector<int>& component) {
  PrescribedRegion region;
  std::set<int> in_a_loop;
  std::size_t corners = 0;
  for (const int v : component) {
    corners += mesh.triangles_of_vertex(v).size();
    if (marks.interior[at(v)]) {
      if (marks.handle[at(v)] != kNone) region.inside.push_back(marks.handle[at(v)]);
    } else if (!in_a_loop.contains(v)) {
      std::vector<int>& loop = region.loops.emplace_back(boundary_loop(neighbours, v));
      in_a_loop.insert(loop.begin(), loop.end());
      for (int& of_vertex : loop) of_vertex = marks.handle[at(of_vertex)];
    }
  }
  // Triangles have three sides; those at the boundary are on one triangle, the others on two.
  const std::size_t edges = (corners + in_a_loop.size()) / 2, faces = corners / 3;
  region.euler_characteristic =
      static_cast<int>(component.size()) - static_cast<int>(edges) + static_cast<int>(faces);
  return region;
}

}  // namespace

std::vector<PrescribedRegion> prescribed_regions(const MeshPair& mesh,
                                                 const Constraints& constraints) {
  const auto neighbours = boundary_neighbours(mesh.triangles(), mesh.vertex_count());
  const VertexMarks marks = marks_of(mesh, constraints, neighbours);
  const std::vector<std::vector<int>> components = prescribed_components(mesh, marks);
  std::vector<PrescribedRegion> regions;
  regions.reserve(components.size());
  for (const std::vector<int>& component : components)
    regions.push_back(region_of(mesh, marks, neighbours, component));
  return regions;
}

std::vector<int> vertices_of(const std::vector<int>& handles, const Constraints& constraints) {
  std::vector<int> vertices;
  vertices.reserve(handles.size());
  for (const int handle : handles) vertices.push_back(constraints.vertices[at(handle)]);
  return vertices;
}

std::vector<int> boundary_vertices(const std::vector<PrescribedRegion>& regions,
                                   const Constraints& constraints) {
  std::vector<int> vertices;
  for (const PrescribedRegion& region : regions)
    for (const std::vector<int>& loop : region.loops)
      for (const int handle : loop) vertices.push_back(constraints.vertices[at(handle)]);
  std::ranges::sort(vertices);
  return vertices;
}

}  // namespace foldless
