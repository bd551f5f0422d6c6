// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/mesh_source.h"

#include "core/error.h"

namespace foldless {
namespace {

std::string place(const std::string& name, const std::vector<int>& lines, int index) {
  if (lines.empty()) return name + ": ";
  return name + ':' + std::to_string(lines[static_cast<std::size_t>(index)]) + ": ";
}

}  // namespace

std::string MeshSource::at_vertex(int v) const {
  return place(name, vertex_lines, v) + part + "vertex " + number(v);
}

std::string MeshSource::at_face(int face) const {
  return place(name, face_lines, face) + part + "face " + number(face);
}

std::string MeshSource::at_triangle(int t, const Triangles& triangles) const {
  const bool cut = !face_of_triangle.empty();
  return at_face(cut ? face_of_triangle[static_cast<std::size_t>(t)] : t) + " (vertices " +
         number(triangles(0, t)) + ' ' + number(triangles(1, t)) + ' ' + number(triangles(2, t)) +
         ')';
}

std::string counted(std::size_t count, std::string_view noun) {
  std::string words = std::to_string(count) + ' ' + std::string(noun);
  if (count == 1) return words;
  if (noun.ends_with("vertex")) return words.replace(words.size() - 2, 2, "ices");
  return words + 's';
}

void refuse(const std::string& first, std::size_t count, std::string_view noun,
            std::string_view advice) {
  throw Error(first + " (" + counted(count, noun) + " in all); " + std::string(advice));
}

}  // namespace foldless
