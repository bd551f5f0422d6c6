// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/placed_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/depth/paint_order.h"

namespace foldless {
namespace {

constexpr double kStrip = 1;  // pixels; wider than a soft edge
constexpr double kDot = 1.5;  // pixels; half a diagonal, so that a pixel is covered

std::vector<glm::dvec2> plain_points(const Points& points) {
  std::vector<glm::dvec2> plain;
  plain.reserve(static_cast<std::size_t>(points.cols()));
  for (const auto& p : points.colwise()) plain.emplace_back(p.x(), p.y());
  return plain;
}

Box box_round(const std::vector<glm::dvec2>& points) {
  if (points.empty()) return {};
  Box box{points.front(), points.front()};
  for (const glm::dvec2& p : points) box = {glm::min(box.min, p), glm::max(box.max, p)};
  return box;
}

/// The corner of a triangle after which a side with these ends comes.
std::size_t side_of(const PlacedMesh& mesh, int triangle, const MeshEdge& edge) {
  const auto corners = mesh.vertices_of(triangle);
  std::size_t k = 0;
  while (k < 2 && !((corners[k] == edge.a && corners[(k + 1) % 3] == edge.b) ||
                    (corners[k] == edge.b && corners[(k + 1) % 3] == edge.a)))
    ++k;
  return k;
}

void find_neighbours(PlacedMesh& mesh) {
  mesh.neighbours.assign(mesh.sheets.size(), {-1, -1, -1});
  for (const MeshEdge& edge : mesh.edges[static_cast<std::size_t>(EdgeSet::interior)]) {
    const auto set = [&](int triangle, int other) {
      mesh.neighbours[static_cast<std::size_t>(triangle)][side_of(mesh, triangle, edge)] = other;
    };
    set(edge.triangle, edge.other);
    set(edge.other, edge.triangle);
  }
}

/// How far the strip goes from the side a b towards the corner of the neighbour beyond it, as a
/// share of the way.
double share_of_strip(glm::dvec2 a, glm::dvec2 b, glm::dvec2 corner) {
  const glm::dvec2 side = b - a, way = corner - a;
  const double length = glm::length(side);
  const double height = std::abs(side.x * way.y - side.y * way.x) / length;
  return height > kStrip ? kStrip / height : 1;
}

/// The vertex of a triangle beside two others of it.
std::size_t third_vertex(const PlacedMesh& mesh, int triangle, std::size_t a, std::size_t b) {
  const auto corners = mesh.vertices_of(triangle);
  return corners[0] + corners[1] + corners[2] - a - b;
}

}  // namespace

std::array<std::size_t, 3> PlacedMesh::vertices_of(int triangle) const {
  const std::size_t first = 3 * static_cast<std::size_t>(triangle);
  return {corners[first], corners[first + 1], corners[first + 2]};
}

std::span<const int> PlacedMesh::triangles_of(std::size_t sheet) const {
  const std::size_t first = triangles.first[sheet * part_count];
  return std::span(triangles.order)
      .subspan(first, triangles.first[(sheet + 1) * part_count] - first);
}

std::size_t PlacedMesh::sheet_count() const { return (triangles.first.size() - 1) / part_count; }

PlacedMesh placed_mesh(const Snapshot& snapshot, const MeshView& view) {
  PlacedMesh mesh;
  const Points& points = view.pose == Pose::rest ? *snapshot.rest : snapshot.deformed;
  mesh.places = plain_points(points);
  for (glm::dvec2& place : mesh.places) place = world_to_pixel(view.camera, view.viewport, place);
  mesh.rest = plain_points(*snapshot.rest);
  mesh.rest_box = box_round(mesh.rest);
  for (const int v : snapshot.triangles->reshaped())
    mesh.corners.push_back(static_cast<std::uint32_t>(v));
  PaintOrder order;
  order.set_parts(view.parts);
  mesh.sheets = order.layers(snapshot, points);
  const MeshParts none;
  const MeshParts& parts = view.parts ? *view.parts : none;
  mesh.parts =
      parts_of_triangles(*snapshot.triangles, static_cast<int>(snapshot.rest->cols()), parts);
  mesh.part_count = std::max<std::size_t>(1, parts.size());
  mesh.triangles = lists_by_part(mesh.sheets, mesh.parts, mesh.part_count);
  mesh.edges = edge_lists(mesh.corners,
                          snapshot.flipped_edges ? *snapshot.flipped_edges : std::vector<Edge>());
  for (std::size_t set = 0; set < mesh.edges.size(); ++set)
    mesh.edges_by_sheet[set] = edges_by_sheet(mesh.edges[set], mesh.sheets);
  find_neighbours(mesh);
  return mesh;
}

std::vector<Polygon> grown(const PlacedMesh& mesh, int triangle,
                           const std::function<bool(std::size_t, std::size_t)>& grows) {
  const auto t = static_cast<std::size_t>(triangle);
  const auto corners = mesh.vertices_of(triangle);
  std::vector<Polygon> pieces(1);
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec2 a = mesh.places[corners[k]], b = mesh.places[corners[(k + 1) % 3]];
    pieces.front().push_back(a);
    const int other = mesh.neighbours[t][k];
    if (other < 0 || a == b || !grows(t, static_cast<std::size_t>(other))) continue;
    const glm::dvec2 beyond =
        mesh.places[third_vertex(mesh, other, corners[k], corners[(k + 1) % 3])];
    const double share = share_of_strip(a, b, beyond);
    pieces.push_back({a, a + share * (beyond - a), b + share * (beyond - b), b});
  }
  return pieces;
}

PaintedInTurn::PaintedInTurn(const PlacedMesh& mesh, const std::vector<int>& numbers)
    : mesh_(mesh), numbers_(numbers), first_at_(mesh.places.size(), -1) {
  for (std::size_t i = 0; i < mesh.corners.size(); ++i) {
    int& first = first_at_[mesh.corners[i]];
    const std::size_t t = i / 3;
    if (first < 0 || numbers[t] < numbers[static_cast<std::size_t>(first)])
      first = static_cast<int>(t);
  }
  for (const MeshEdge& edge : mesh.edges[static_cast<std::size_t>(EdgeSet::boundary)])
    first_at_[edge.a] = first_at_[edge.b] = -1;
}

std::vector<Polygon> PaintedInTurn::pieces_of(int triangle) const {
  std::vector<Polygon> pieces = grown(mesh_, triangle, [this](std::size_t t, std::size_t other) {
    return numbers_[other] > numbers_[t];
  });
  for (const std::size_t v : mesh_.vertices_of(triangle)) {
    if (first_at_[v] != triangle) continue;
    const glm::dvec2 p = mesh_.places[v];
    pieces.push_back({p + glm::dvec2(-kDot, 0), p + glm::dvec2(0, -kDot), p + glm::dvec2(kDot, 0),
                      p + glm::dvec2(0, kDot)});
  }
  return pieces;
}

}  // namespace foldless
