// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/mesh_text.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <string_view>

#include "core/files/text_lines.h"
#include "core/large_pages.h"

namespace foldless {
namespace {

/// A line of numbers, put together in place: large meshes have millions of them.
class NumbersLine {
 public:
  void add(std::string_view words) { end_ = std::ranges::copy(words, end_).out; }
  /// The shortest form; the characters it took, which live as long as the line.
  template <typename Number>
  std::string_view add_number(Number value) {
    char* const begin = end_;
    end_ = std::to_chars(begin, room_.data() + room_.size(), value).ptr;
    return {begin, end_};
  }
  std::string_view text() const { return {room_.data(), end_}; }

 private:
  std::array<char, 128> room_;  // three integers twice, or two doubles, and what is between
  char* end_ = room_.data();
};

void append_points(std::string& text, std::string_view before, const Points& points,
                   std::string_view after) {
  for (const auto& p : points.colwise()) {
    NumbersLine line;
    line.add(before);
    line.add_number(p.x());
    line.add(" ");
    line.add_number(p.y());
    line.add(after);
    text += line.text();
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
    NumbersLine line;
    line.add("f");
    for (const int v : t) {
      line.add(" ");
      const std::string_view number = line.add_number(v + 1);
      if (!is_textured) continue;
      line.add("/");
      line.add(number);
    }
    line.add("\n");
    text += line.text();
  }
}

/// Hardly ever are there more bytes. Of a million triangles it is a hundred megabytes: growing
/// would copy it some times, and of its small pages every one would be a fault.
std::string with_room(Eigen::Index points, Eigen::Index triangles) {
  constexpr Eigen::Index kOfAPoint = 50, kOfATriangle = 48;
  std::string text;
  text.reserve(static_cast<std::size_t>(kOfAPoint * points + kOfATriangle * triangles));
  ask_for_large_pages(text.data(), text.capacity());
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

std::string lines_after(const Triangles& triangles, const Points& coordinates) {
  std::string text = with_room(coordinates.cols(), triangles.cols());
  append_points(text, "vt ", coordinates, "\n");
  append_obj_faces(text, triangles, coordinates.cols() > 0);
  return text;
}

}  // namespace

std::string obj_vertex_lines(const Points& points) {
  std::string text = with_room(points.cols(), 0);
  append_points(text, "v ", points, " 0\n");
  return text;
}

std::string obj_lines_after_vertices(const Triangles& triangles, const Points* rest) {
  return lines_after(triangles,
                     rest && rest->cols() > 0 ? texture_coordinates(*rest) : Points(2, 0));
}

std::string obj_text(const Triangles& triangles, const Points& points, const Points* rest) {
  return obj_vertex_lines(points) + obj_lines_after_vertices(triangles, rest);
}

std::string textured_obj_text(const Triangles& triangles, const Points& points,
                              const Points& coordinates) {
  assert(coordinates.cols() == points.cols());
  return obj_vertex_lines(points) + lines_after(triangles, coordinates);
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
