// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/mesh_place.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "app/editor/picking.h"

namespace foldless {
namespace {

/// How near the pointer must be to a vertex or an edge. [design pixels]
constexpr double kVertexReach = 7;
constexpr double kEdgeReach = 4;
/// Neither takes more than this part of the triangle's height, so that every part can be hit.
constexpr double kShare = 0.3;

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double length = along.squaredNorm();
  const double t = length > 0 ? std::clamp((p - a).dot(along) / length, 0.0, 1.0) : 0.0;
  return (a + t * along - p).norm();
}

/// A triangle on screen.
using Corners = std::array<Vec2, 3>;

double smallest_height(const Corners& c) {
  const double longest =
      std::max({(c[1] - c[0]).norm(), (c[2] - c[1]).norm(), (c[0] - c[2]).norm()});
  return longest > 0 ? 2 * std::abs(signed_area(c[0], c[1], c[2])) / longest : 0;
}

std::string number_words(const char* format, double a, double b) {
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), format, a, b);
  return text.data();
}

std::string triangle_words(const MeshPlace& place, const Snapshot& s) {
  const Eigen::Vector3i t = s.triangles->col(place.triangle);
  const Vec2 sigma = signed_singular_values(deformation_gradient(*s.rest, s.deformed, t));
  return "Triangle " + std::to_string(place.triangle) +
         number_words(": A′/A %.3g, σ₁/σ₂ %.3g", sigma[0] * sigma[1], sigma[0] / sigma[1]);
}

std::string edge_words(const MeshPlace& place, const Snapshot& s) {
  const Edge edge{place.corners[0], place.corners[1]};
  std::string words = "Edge " + std::to_string(edge[0]) + "–" + std::to_string(edge[1]);
  if (edge[1] >= s.original_vertices) return words + ", made by a split";
  const bool is_flipped =
      s.flipped_edges && std::binary_search(s.flipped_edges->begin(), s.flipped_edges->end(), edge);
  return is_flipped ? words + ", flipped" : words;
}

}  // namespace

std::optional<MeshPlace> place_at(const Triangles& triangles, const Points& points,
                                  const Canvas& canvas, const Vec2& pixel) {
  const auto under = triangle_at(triangles, points, canvas.to_world(pixel));
  if (!under) return std::nullopt;
  const Eigen::Vector3i t = triangles.col(*under);
  const Corners corners{canvas.to_pixel(points.col(t[0])), canvas.to_pixel(points.col(t[1])),
                        canvas.to_pixel(points.col(t[2]))};
  const double most = kShare * smallest_height(corners);
  const double vertex_reach = std::min(kVertexReach * canvas.ui_scale, most);
  const double edge_reach = std::min(kEdgeReach * canvas.ui_scale, most);
  for (int k = 0; k < 3; ++k)
    if ((corners[static_cast<std::size_t>(k)] - pixel).norm() <= vertex_reach)
      return MeshPlace{*under, {t[k]}};
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    if (distance_to_segment(pixel, corners[static_cast<std::size_t>(k)],
                            corners[static_cast<std::size_t>(next)]) <= edge_reach)
      return MeshPlace{*under, {std::min(t[k], t[next]), std::max(t[k], t[next])}};
  }
  return MeshPlace{*under, {t[0], t[1], t[2]}};
}

std::string words_of(const MeshPlace& place, const Snapshot& snapshot) {
  if (place.corners.size() == 3) return triangle_words(place, snapshot);
  if (place.corners.size() == 2) return edge_words(place, snapshot);
  const std::string words = "Vertex " + std::to_string(place.corners.front());
  return place.corners.front() >= snapshot.original_vertices ? words + ", made by a split" : words;
}

}  // namespace foldless
