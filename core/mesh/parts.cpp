// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/parts.h"

#include <algorithm>

#include "core/mesh/components.h"

namespace foldless {

std::vector<int> parts_of_triangles(const Triangles& triangles, int vertices,
                                    std::span<const MeshPart> parts) {
  std::vector<int> of_triangle(static_cast<std::size_t>(triangles.cols()), 0);
  if (parts.empty()) return of_triangle;
  const std::vector<int> component = components_of(triangles, vertices);
  const auto component_of = [&](int v) {
    return static_cast<std::size_t>(component[static_cast<std::size_t>(v)]);
  };
  std::vector<int> of_component(component.size(), 0);
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (int v = parts[p].first_vertex;
         v < std::min(parts[p].first_vertex + parts[p].vertices, vertices); ++v)
      of_component[component_of(v)] = static_cast<int>(p);
  for (std::size_t t = 0; t < of_triangle.size(); ++t)
    of_triangle[t] = of_component[component_of(triangles(0, static_cast<Eigen::Index>(t)))];
  return of_triangle;
}

}  // namespace foldless
