// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outline/triangulate.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <numbers>
#include <queue>
#include <string>
#include <unordered_map>

#include "core/error.h"

namespace foldless {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Delaunay_mesh_vertex_base_2<Kernel>;
using Face = CGAL::Delaunay_mesh_face_base_2<Kernel>;
using Storage = CGAL::Triangulation_data_structure_2<Vertex, Face>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Storage,
                                               CGAL::No_constraint_intersection_tag>;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Triangulation>;
using Mesher = CGAL::Delaunay_mesher_2<Triangulation, Criteria>;
using VertexHandle = Triangulation::Vertex_handle;
using FaceHandle = Triangulation::Face_handle;
using VertexLoop = std::vector<VertexHandle>;

std::string at(const Vec2& p) {
  return "at (" + std::to_string(p.x()) + ", " + std::to_string(p.y()) + ")";
}

Vec2 position(VertexHandle v) { return {v->point().x(), v->point().y()}; }

void check_options(const TriangulateOptions& options) {
  if (!(options.edge_length >= 0) || !std::isfinite(options.edge_length))
    throw Error("the edge length of a mesh must be a positive number");
  if (!(options.min_angle >= 0 && options.min_angle <= 33))
    throw Error("the smallest angle of a mesh must lie between 0 and 33 degrees");
}

VertexLoop insert_corners(const Loop& loop, Triangulation& triangulation) {
  if (loop.size() < 3) throw Error("a loop of the outline has fewer than 3 corners");
  VertexLoop handles;
  for (const Vec2& p : loop) {
    if (!p.allFinite()) throw Error("the outline has a coordinate that is not a finite number");
    const std::size_t before = triangulation.number_of_vertices();
    handles.push_back(triangulation.insert({p.x(), p.y()}));
    if (triangulation.number_of_vertices() == before)
      throw Error("the outline visits a point twice, " + at(p) + "; every corner must be its own");
  }
  return handles;
}

/// Edges that pass through a corner or cross an edge are refused, so that loops are simple and
/// disjoint.
void insert_edges(const VertexLoop& loop, Triangulation& triangulation) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const VertexHandle a = loop[i], b = loop[(i + 1) % loop.size()];
    const Vec2 middle = 0.5 * (position(a) + position(b));
    try {
      triangulation.insert_constraint(a, b);
    } catch (const Triangulation::Intersection_of_constraints_exception&) {
      throw Error("the outline crosses itself near the edge " + at(middle));
    }
    FaceHandle face;
    int index = 0;
    if (!triangulation.is_edge(a, b, face, index) || !face->is_constrained(index))
      throw Error("the outline touches itself on the edge " + at(middle));
  }
}

using Levels = std::unordered_map<const Triangulation::Face*, int>;

/// Number of loops round each face: 0 outside, 1 in the region, 2 in a hole.
Levels nesting_levels(const Triangulation& triangulation) {
  Levels levels{{&*triangulation.infinite_face(), 0}};
  std::queue<FaceHandle> inner;
  std::queue<FaceHandle> outer;
  outer.push(triangulation.infinite_face());
  while (!outer.empty() || !inner.empty()) {
    // Whole regions first: a face behind a constraint is one level deeper than this region.
    auto& queue = inner.empty() ? outer : inner;
    const FaceHandle face = queue.front();
    queue.pop();
    const int level = levels.at(&*face);
    for (int k = 0; k < 3; ++k) {
      const bool crosses = face->is_constrained(k);
      const FaceHandle neighbour = face->neighbor(k);
      if (levels.try_emplace(&*neighbour, level + (crosses ? 1 : 0)).second)
        (crosses ? outer : inner).push(neighbour);
    }
  }
  return levels;
}

/// Both sides of every edge of the loop must be `outside` and `outside` + 1 loops deep.
void check_nesting(const VertexLoop& loop, int outside, const Triangulation& triangulation,
                   const Levels& levels) {
  FaceHandle face;
  int index = 0;
  triangulation.is_edge(loop[0], loop[1], face, index);
  const int left = levels.at(&*face), right = levels.at(&*face->neighbor(index));
  if (std::min(left, right) != outside)
    throw Error("the hole of the outline " + at(position(loop[0])) +
                " is not inside the boundary alone");
}

void mark_domain(const std::vector<VertexLoop>& loops, Triangulation& triangulation) {
  const Levels levels = nesting_levels(triangulation);
  for (std::size_t i = 0; i < loops.size(); ++i)
    check_nesting(loops[i], i == 0 ? 0 : 1, triangulation, levels);
  for (const FaceHandle face : triangulation.all_face_handles())
    face->set_in_domain(levels.at(&*face) == 1);
}

void refine(const TriangulateOptions& options, Triangulation& triangulation) {
  const double sine = std::sin(options.min_angle * std::numbers::pi / 180);
  Mesher mesher(triangulation, Criteria(sine * sine, options.edge_length));
  mesher.init(true);
  while (!options.stop.stop_requested() && mesher.try_one_step_refine_mesh())
    if (triangulation.number_of_vertices() > static_cast<std::size_t>(options.vertex_limit))
      throw Error("the mesh of the outline would have more than " +
                  std::to_string(options.vertex_limit) + " vertices; allow longer edges");
}

Shape collect(const std::vector<VertexLoop>& loops, const Triangulation& triangulation) {
  std::unordered_map<const Triangulation::Vertex*, int> index;
  std::vector<Vec2> points;
  const auto number = [&](VertexHandle v) {
    const auto [entry, is_new] = index.try_emplace(&*v, static_cast<int>(points.size()));
    if (is_new) points.push_back(position(v));
    return entry->second;
  };
  for (const VertexLoop& loop : loops)
    for (const VertexHandle v : loop) number(v);
  std::vector<Eigen::Vector3i> triangles;
  for (const FaceHandle f : triangulation.finite_face_handles()) {
    if (!f->is_in_domain()) continue;
    const int a = number(f->vertex(0)), b = number(f->vertex(1)), c = number(f->vertex(2));
    triangles.emplace_back(a, b, c);
  }
  Shape shape;
  shape.rest.resize(2, static_cast<Eigen::Index>(points.size()));
  for (std::size_t v = 0; v < points.size(); ++v) shape.rest.col(v) = points[v];
  shape.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
  for (std::size_t t = 0; t < triangles.size(); ++t) shape.triangles.col(t) = triangles[t];
  return shape;
}

}  // namespace

Shape triangulate(const Outline& outline, const TriangulateOptions& options) {
  check_options(options);
  Triangulation triangulation;
  std::vector<VertexLoop> loops{insert_corners(outline.boundary, triangulation)};
  for (const Loop& hole : outline.holes) loops.push_back(insert_corners(hole, triangulation));
  if (triangulation.dimension() < 2) throw Error("the outline has no area");
  for (const VertexLoop& loop : loops) insert_edges(loop, triangulation);
  mark_domain(loops, triangulation);
  refine(options, triangulation);
  return collect(loops, triangulation);
}

}  // namespace foldless
