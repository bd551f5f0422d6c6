// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/validate.h"

#include <algorithm>
#include <array>

#include "core/files/twins.h"
#include "core/mesh/injective.h"
#include "core/mesh/orientation.h"

namespace foldless {
namespace {

constexpr std::string_view kZeroArea = "every triangle must have an area";

/// Triangles by the sign of their area, and the first of each kind.
struct Signs {
  std::array<std::size_t, 3> count{};
  std::array<int, 3> first{-1, -1, -1};
};
constexpr std::size_t kNegative = 0, kZero = 1, kPositive = 2;

Signs signs_of(const Triangles& triangles, const Points& points) {
  Signs signs;
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    const auto sign = static_cast<std::size_t>(orientation(points, triangles.col(t)) + 1);
    if (signs.count[sign]++ == 0) signs.first[sign] = static_cast<int>(t);
  }
  return signs;
}

std::string edge_name(const Triangles& triangles, int halfedge, const MeshSource& source) {
  const Eigen::Vector2i ends = halfedge_ends(triangles, halfedge);
  return source.number(ends[0]) + '-' + source.number(ends[1]);
}

void check_crowded_edges(const Triangles& triangles, const Twins& twins, const MeshSource& source) {
  if (!twins.first_crowded) return;
  const int h = *twins.first_crowded;
  refuse(source.at_triangle(h / 3, triangles) + " has the edge " + edge_name(triangles, h, source) +
             " of " + std::to_string(twins.first_crowded_triangles) + " triangles",
         static_cast<std::size_t>(twins.crowded_edges), "non-manifold edge",
         "an edge can have two triangles at most");
}

void check_same_side_edges(const Triangles& triangles, const Twins& twins,
                           const MeshSource& source) {
  if (!twins.first_same_side) return;
  const int h = *twins.first_same_side;
  refuse(source.at_triangle(h / 3, triangles) + " and its neighbour pass the edge " +
             edge_name(triangles, h, source) + " in the same direction",
         static_cast<std::size_t>(twins.same_side_edges), "edge",
         "orient all faces the same way, and remove faces that lie on each other");
}

void check_bow_ties(const Triangles& triangles, const Twins& twins, int vertex_count,
                    const MeshSource& source) {
  const std::vector<int> bow_ties = bow_tie_vertices(triangles, twins, vertex_count);
  if (bow_ties.empty()) return;
  refuse(source.at_vertex(bow_ties[0]) + " is a bow tie: triangles meet there in one point only",
         bow_ties.size(), "non-manifold vertex",
         "give each part of the mesh a vertex of its own, or join the parts by an edge");
}

void check_zero_area(const Signs& signs, const TriangleSoup& mesh) {
  if (signs.count[kZero] == 0) return;
  refuse(mesh.source.at_triangle(signs.first[kZero], mesh.triangles) + " has zero area",
         signs.count[kZero], "triangle", kZeroArea);
}

/// Names the fewer ones as the wrong ones.
void check_mixed_orientation(const Signs& signs, const TriangleSoup& mesh) {
  if (signs.count[kNegative] == 0 || signs.count[kPositive] == 0) return;
  const bool clockwise = signs.count[kNegative] <= signs.count[kPositive];
  const std::size_t wrong = clockwise ? kNegative : kPositive;
  refuse(mesh.source.at_triangle(signs.first[wrong], mesh.triangles) + " is " +
             (clockwise ? "clockwise" : "counter-clockwise") + ", others are " +
             (clockwise ? "counter-clockwise" : "clockwise") + ": mixed orientation",
         signs.count[wrong], "triangle", "orient all faces the same way and unfold the mesh");
}

/// Squares of lengths must be numbers, and so must their squares.
void check_size(const Points& points, const MeshSource& source) {
  constexpr double kMost = 1e75, kLeast = 1e-75;
  Eigen::Index v = 0;
  const Eigen::VectorXd reach = points.cwiseAbs().colwise().maxCoeff();
  if (reach.maxCoeff(&v) > kMost)
    refuse(source.at_vertex(static_cast<int>(v)) + " is farther from (0, 0) than 1e75",
           static_cast<std::size_t>((reach.array() > kMost).count()), "vertex",
           "use a larger unit of length");
  const Vec2 extent = points.rowwise().maxCoeff() - points.rowwise().minCoeff();
  if (extent.maxCoeff() < kLeast)
    refuse(source.at_vertex(0) + " and all others lie within 1e-75",
           static_cast<std::size_t>(points.cols()), "vertex", "use a smaller unit of length");
}

void check_covers(const InjectivityReport& report, const MeshSource& source) {
  if (!report.first_branch_vertex) return;
  refuse(source.at_vertex(*report.first_branch_vertex) +
             " is covered more than once: the angles round it add up to more than a full turn",
         static_cast<std::size_t>(report.branch_vertices), "interior vertex",
         "lay the mesh flat without overlap round its interior vertices");
}

void check_boundary(const InjectivityReport& report, const MeshSource& source) {
  const std::vector<int>& overlaps = report.overlapping_boundary_vertices;
  if (overlaps.empty()) return;
  refuse(source.at_vertex(overlaps.front()) +
             " overlaps itself: its angles add up to a full turn or more",
         overlaps.size(), "boundary vertex",
         "open the gap between its two boundary edges, or cut the mesh there");
}

/// Triangles that are all clockwise become counter-clockwise.
void turn_over(TriangleSoup& mesh) {
  mesh.triangles.row(1).swap(mesh.triangles.row(2));
  mesh.notices.push_back(mesh.source.name + ": all triangles were clockwise (" +
                         counted(static_cast<std::size_t>(mesh.triangles.cols()), "triangle") +
                         " in all); they have been turned over");
}

void note_unreferenced(TriangleSoup& mesh) {
  std::vector<bool> used(static_cast<std::size_t>(mesh.points.cols()), false);
  for (const int v : mesh.triangles.reshaped()) used[static_cast<std::size_t>(v)] = true;
  const auto count = static_cast<std::size_t>(std::ranges::count(used, false));
  if (count == 0) return;
  const int first = static_cast<int>(std::ranges::find(used, false) - used.begin());
  mesh.notices.push_back(mesh.source.at_vertex(first) + " belongs to no face (" +
                         counted(count, "vertex") +
                         " in all); such vertices are kept but stay "
                         "where they are");
}

}  // namespace

void check_connectivity(const Triangles& triangles, int vertex_count, const MeshSource& source) {
  const Twins twins = find_twins(triangles, vertex_count);
  check_crowded_edges(triangles, twins, source);
  check_same_side_edges(triangles, twins, source);
  check_bow_ties(triangles, twins, vertex_count, source);
}

void check_positions(const Triangles& triangles, const Points& points, const MeshSource& source,
                     BoundaryOverlaps allowed) {
  check_size(points, source);
  const InjectivityReport report = check_injectivity(triangles, points);
  if (report.first_degenerate)
    refuse(source.at_triangle(*report.first_degenerate, triangles) + " has zero area",
           static_cast<std::size_t>(report.degenerate), "triangle", kZeroArea);
  if (report.first_inverted)
    refuse(source.at_triangle(*report.first_inverted, triangles) + " is clockwise",
           static_cast<std::size_t>(report.inverted), "triangle",
           "every triangle must be counter-clockwise");
  check_covers(report, source);
  if (allowed == BoundaryOverlaps::refused) check_boundary(report, source);
}

TriangleSoup validated(TriangleSoup mesh) {
  const int vertex_count = static_cast<int>(mesh.points.cols());
  check_crowded_edges(mesh.triangles, find_twins(mesh.triangles, vertex_count), mesh.source);
  const Signs signs = signs_of(mesh.triangles, mesh.points);
  check_zero_area(signs, mesh);
  check_mixed_orientation(signs, mesh);
  if (signs.count[kPositive] == 0) turn_over(mesh);
  check_connectivity(mesh.triangles, vertex_count, mesh.source);
  check_positions(mesh.triangles, mesh.points, mesh.source);
  note_unreferenced(mesh);
  return mesh;
}

}  // namespace foldless
