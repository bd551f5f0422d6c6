// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/inline_mesh.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace foldless {
namespace {

std::vector<int> lines_of_items(const JsonValue& array) {
  std::vector<int> lines;
  for (const JsonNode& item : *array.node().as<JsonNode::Array>()) lines.push_back(item.line);
  return lines;
}

}  // namespace

TriangleSoup read_inline_triangles(const JsonValue& vertices, const JsonValue& triangles,
                                   const std::string& file, std::string part) {
  PolygonSoup soup;
  const Points points = vertices.points();
  for (const auto& p : points.colwise()) soup.vertices.push_back({p.x(), p.y(), 0});
  const Triangles corners = triangles.triangles();
  soup.corners.assign(corners.data(), corners.data() + corners.size());
  for (Eigen::Index t = 0; t < corners.cols(); ++t)
    soup.ends.push_back(static_cast<std::size_t>(3 * (t + 1)));
  soup.source.name = file;
  soup.source.part = std::move(part);
  soup.source.vertex_lines = lines_of_items(vertices);
  soup.source.face_lines = lines_of_items(triangles);
  return planar_triangles(std::move(soup));
}

}  // namespace foldless
