// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/mesh_text.h"

#include <cassert>
#include <string_view>

#include "core/files/text_lines.h"

namespace foldless {
namespace {

void append_points(std::string& text, std::string_view before, const Points& points,
                   std::string_view after) {
  for (const auto& p : points.colwise()) {
    text += before;
    append_number(text, p.x());
    text += ' ';
    append_number(text, p.y());
    text += after;
  }
}

/// Faces as OFF and PLY have them, counted from 0.
void append_sized_faces(std::string& text, const Triangles& triangles) {
  for (const auto& t : triangles.colwise()) {
    text += '3';
    for (const int v : t) append_number(text += ' ', v);
    text += '\n';
  }
}

/// Faces counted from 1; `v/vt` where every vertex has a texture coordinate.
void append_obj_faces(std::string& text, const Triangles& triangles, bool is_textured) {
  for (const auto& t : triangles.colwise()) {
    text += 'f';
    for (const int v : t) {
      append_number(text += ' ', v + 1);
      if (is_textured) append_number(text += '/', v + 1);
    }
    text += '\n';
  }
}

/// For the text with texture coordinates, which hardly ever has more bytes. Of a million triangles
/// it is a hundred megabytes: growing would copy it some times.
std::string with_room(const Triangles& triangles, const Points& points) {
  constexpr Eigen::Index kOfAPoint = 100, kOfATriangle = 48;
  std::string text;
  text.reserve(
      static_cast<std::size_t>(kOfAPoint * points.cols() + kOfATriangle * triangles.cols()));
  return text;
}

Points texture_coordinates(const Points& rest) {
  const Vec2 low = rest.rowwise().minCoeff();
  const double side = (rest.rowwise().maxCoeff() - low).maxCoeff();
  const Points moved = rest.colwise() - low;
  return side > 0 ? Points(moved / side) : moved;
}

std::string sizes(const Triangles& triangles, const Points& points) {
  return std::to_string(points.cols()) + ' ' + std::to_string(triangles.cols());
}

}  // namespace

std::string obj_text(const Triangles& triangles, const Points& points, const Points* rest) {
  if (rest && rest->cols() > 0)
    return textured_obj_text(triangles, points, texture_coordinates(*rest));
  std::string text = with_room(triangles, points);
  append_points(text, "v ", points, " 0\n");
  append_obj_faces(text, triangles, false);
  return text;
}

std::string textured_obj_text(const Triangles& triangles, const Points& points,
                              const Points& coordinates) {
  assert(coordinates.cols() == points.cols());
  std::string text = with_room(triangles, points);
  append_points(text, "v ", points, " 0\n");
  append_points(text, "vt ", coordinates, "\n");
  append_obj_faces(text, triangles, true);
  return text;
}

std::string off_text(const Triangles& triangles, const Points& points) {
  std::string text = "OFF\n" + sizes(triangles, points) + " 0\n";
  append_points(text, "", points, " 0\n");
  append_sized_faces(text, triangles);
  return text;
}

std::string ply_text(const Triangles& triangles, const Points& points) {
  std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(points.cols()) +
                     "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                     std::to_string(triangles.cols()) +
                     "\nproperty list uchar int vertex_indices\nend_header\n";
  append_points(text, "", points, " 0\n");
  append_sized_faces(text, triangles);
  return text;
}

}  // namespace foldless
