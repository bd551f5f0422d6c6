// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/delaunay.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace foldless {
namespace {

using DelaunayKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using DelaunayVertex = CGAL::Triangulation_vertex_base_with_info_2<int, DelaunayKernel>;
using Delaunay =
    CGAL::Delaunay_triangulation_2<DelaunayKernel,
                                   CGAL::Triangulation_data_structure_2<DelaunayVertex>>;

}  // namespace

std::optional<Triangles> delaunay_triangles(const Points& points) {
  Delaunay triangulation;
  Delaunay::Face_handle near_by;
  for (Eigen::Index v = 0; v < points.cols(); ++v) {
    const auto vertex = triangulation.insert({points(0, v), points(1, v)}, near_by);
    vertex->info() = static_cast<int>(v);
    near_by = vertex->face();
  }
  if (triangulation.number_of_vertices() != static_cast<std::size_t>(points.cols()))
    return std::nullopt;
  Triangles triangles(3, static_cast<Eigen::Index>(triangulation.number_of_faces()));
  Eigen::Index t = 0;
  for (const auto face : triangulation.finite_face_handles())
    triangles.col(t++) << face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info();
  return triangles;
}

}  // namespace foldless
