// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/mesh_io.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

#include "core/error.h"
#include "core/files/atomic_file.h"
#include "core/files/mesh_readers.h"
#include "core/files/mesh_text.h"
#include "core/files/validate.h"

namespace foldless {
namespace {

namespace fs = std::filesystem;

std::string lower_case_extension(const fs::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

[[noreturn]] void refuse_format(const fs::path& file) {
  throw Error(file.string() + ": not a known mesh format; use .obj, .off or .ply");
}

PolygonSoup read_soup(const fs::path& file) {
  const std::string extension = lower_case_extension(file);
  if (!is_mesh_file(file)) refuse_format(file);
  const std::string bytes = read_file(file);
  if (extension == ".obj") return read_obj(bytes, file.string());
  if (extension == ".off") return read_off(bytes, file.string());
  return read_ply(bytes, file.string());
}

LoadedMesh loaded(TriangleSoup mesh) {
  return {std::move(mesh.triangles), std::move(mesh.points), std::move(mesh.notices)};
}

}  // namespace

bool is_mesh_file(const fs::path& file) {
  const std::string extension = lower_case_extension(file);
  return extension == ".obj" || extension == ".off" || extension == ".ply";
}

LoadedMesh read_mesh(const fs::path& file) {
  return loaded(validated(planar_triangles(read_soup(file))));
}

LoadedMesh read_mesh_of_any_shape(const fs::path& file) {
  TriangleSoup mesh = planar_triangles(read_soup(file));
  check_connectivity(mesh.triangles, static_cast<int>(mesh.points.cols()), mesh.source);
  return loaded(std::move(mesh));
}

void write_mesh(const fs::path& file, const Triangles& triangles, const Points& points,
                const Points* rest) {
  const std::string extension = lower_case_extension(file);
  if (!is_mesh_file(file)) refuse_format(file);
  if (extension != ".obj")
    return write_file_atomically(
        file, extension == ".off" ? off_text(triangles, points) : ply_text(triangles, points));
  const std::string vertices = obj_vertex_lines(points);
  const std::string after = obj_lines_after_vertices(triangles, rest);
  const std::string_view parts[] = {vertices, after};
  write_file_atomically(file, parts);
}

}  // namespace foldless
