// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/polygon_soup.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/error.h"
#include "core/files/text_lines.h"
#include "core/mesh/ear_clipping.h"

namespace foldless {
namespace {

std::string text_of(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

void check_coordinates(const PolygonSoup& soup) {
  Offenders offenders("vertex", "every coordinate must be a finite number");
  for (std::size_t v = 0; v < soup.vertices.size(); ++v)
    for (const double x : soup.vertices[v])
      if (!std::isfinite(x)) {
        offenders.add([&] {
          return soup.source.at_vertex(static_cast<int>(v)) + " has the coordinate " + text_of(x) +
                 ", which is not finite";
        });
        break;
      }
  offenders.refuse();
}

void check_indices(const PolygonSoup& soup) {
  const MeshSource& source = soup.source;
  const int n = static_cast<int>(soup.vertices.size());
  const std::string known =
      n == 0 ? "there are no vertices"
             : "the vertices are " + source.number(0) + " to " + source.number(n - 1);
  Offenders offenders("face", "a face may only name vertices of the mesh");
  for (int f = 0; f < soup.face_count(); ++f) {
    const auto face = soup.face(f);
    const auto bad = std::ranges::find_if(face, [n](int v) { return v < 0 || v >= n; });
    if (bad != face.end())
      offenders.add([&] {
        return source.at_face(f) + " names vertex " + source.number(*bad) + ", but " + known;
      });
  }
  offenders.refuse();
}

/// A vertex that comes twice in a face, or nothing.
std::optional<int> repeated_index(std::span<const int> face) {
  std::vector<int> sorted(face.begin(), face.end());
  std::ranges::sort(sorted);
  const auto twice = std::ranges::adjacent_find(sorted);
  return twice == sorted.end() ? std::nullopt : std::optional(*twice);
}

void check_repetitions(const PolygonSoup& soup) {
  Offenders offenders("face", "the corners of a face must be different vertices");
  for (int f = 0; f < soup.face_count(); ++f) {
    const auto face = soup.face(f);
    if (face.size() == 3 && face[0] != face[1] && face[1] != face[2] && face[2] != face[0])
      continue;
    if (const auto v = repeated_index(face))
      offenders.add([&] {
        return soup.source.at_face(f) + " names vertex " + soup.source.number(*v) + " twice";
      });
  }
  offenders.refuse();
}

void check_not_empty(const PolygonSoup& soup) {
  if (soup.face_count() > 0) return;
  throw Error(soup.source.name + ": " + soup.source.part + "there are no faces (" +
              counted(soup.vertices.size(), "vertex") +
              " and 0 faces in all); a mesh needs at least one triangle");
}

void check_flat(const PolygonSoup& soup) {
  const double z = soup.vertices[0][2];
  double low = z, high = z;
  for (const auto& v : soup.vertices) {
    low = std::min(low, v[2]);
    high = std::max(high, v[2]);
  }
  if (low == high) return;
  const std::string advice = "z varies by " + text_of(high - low) +
                             " and only planar meshes with constant z can be opened";
  Offenders offenders("vertex", advice);
  for (std::size_t v = 0; v < soup.vertices.size(); ++v)
    if (soup.vertices[v][2] != z)
      offenders.add([&] {
        return soup.source.at_vertex(static_cast<int>(v)) +
               " has z = " + text_of(soup.vertices[v][2]) +
               ", but the first vertex has z = " + text_of(z);
      });
  offenders.refuse();
}

void copy_points(const PolygonSoup& soup, Points& points) {
  points.resize(2, static_cast<Eigen::Index>(soup.vertices.size()));
  for (Eigen::Index v = 0; v < points.cols(); ++v) {
    const auto& p = soup.vertices[static_cast<std::size_t>(v)];
    points.col(v) << p[0], p[1];
  }
}

/// Cuts one face into the triangles that it adds.
bool cut_face(std::span<const int> face, const Points& points,
              std::vector<Eigen::Vector3i>& triangles) {
  std::vector<Vec2> polygon;
  for (const int v : face) polygon.emplace_back(points.col(v));
  const auto pieces = clip_ears(polygon);
  if (!pieces) return false;
  for (const auto& [a, b, c] : *pieces)
    triangles.emplace_back(face[static_cast<std::size_t>(a)], face[static_cast<std::size_t>(b)],
                           face[static_cast<std::size_t>(c)]);
  return true;
}

void cut_polygons(const PolygonSoup& soup, TriangleSoup& mesh) {
  std::vector<Eigen::Vector3i> triangles;
  std::vector<int>& face_of = mesh.source.face_of_triangle;
  Offenders tangled("face", "it cannot be cut into triangles");
  std::vector<int> polygons;
  for (int f = 0; f < soup.face_count(); ++f) {
    const auto face = soup.face(f);
    if (face.size() == 3) {
      triangles.emplace_back(face[0], face[1], face[2]);
    } else {
      polygons.push_back(f);
      if (!cut_face(face, mesh.points, triangles))
        tangled.add([&] {
          return mesh.source.at_face(f) + ", a polygon of " + std::to_string(face.size()) +
                 " corners, crosses or touches itself or has more than " +
                 std::to_string(kMaxPolygonCorners);
        });
    }
    face_of.resize(triangles.size(), f);
  }
  tangled.refuse();
  mesh.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    mesh.triangles.col(t) = triangles[static_cast<std::size_t>(t)];
  mesh.notices.push_back(mesh.source.at_face(polygons[0]) + " is a polygon (" +
                         counted(polygons.size(), "polygon") +
                         " in all); polygons have been cut into triangles");
}

void copy_triangles(const PolygonSoup& soup, TriangleSoup& mesh) {
  mesh.triangles = Eigen::Map<const Triangles>(soup.corners.data(), 3, soup.face_count());
}

}  // namespace

std::span<const int> PolygonSoup::face(int f) const {
  const auto i = static_cast<std::size_t>(f);
  const std::size_t begin = i == 0 ? 0 : ends[i - 1];
  return std::span(corners).subspan(begin, ends[i] - begin);
}

TriangleSoup planar_triangles(PolygonSoup soup) {
  check_coordinates(soup);
  check_indices(soup);
  check_repetitions(soup);
  check_not_empty(soup);
  check_flat(soup);
  TriangleSoup mesh;
  copy_points(soup, mesh.points);
  mesh.source = std::move(soup.source);
  const bool only_triangles = soup.corners.size() == 3 * soup.ends.size() &&
                              std::ranges::all_of(soup.ends, [](auto end) { return end % 3 == 0; });
  if (only_triangles)
    copy_triangles(soup, mesh);
  else
    cut_polygons(soup, mesh);
  return mesh;
}

}  // namespace foldless
