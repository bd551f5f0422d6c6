// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/mesh_sheets.h"

#include <algorithm>
#include <utility>

namespace foldless {

EdgeLists edge_lists(std::span<const std::uint32_t> corners, const std::vector<Edge>& flipped) {
  auto [interior, boundary] = mesh_edges(corners);
  std::vector<MeshEdge> found_flipped;
  for (const Edge& edge : flipped) {
    const auto a = static_cast<std::uint32_t>(edge[0]), b = static_cast<std::uint32_t>(edge[1]);
    const MeshEdge* found = find_edge(interior, a, b);
    found_flipped.push_back(found ? *found : MeshEdge{a, b});
  }
  return {std::move(interior), std::move(boundary), std::move(found_flipped)};
}

std::size_t count_of_sheets(const std::vector<int>& sheets) {
  const int most = sheets.empty() ? 0 : *std::ranges::max_element(sheets);
  return static_cast<std::size_t>(most) + 1;
}

LayerLists lists_by_part(const std::vector<int>& sheets, const std::vector<int>& parts,
                         std::size_t count_of_parts) {
  std::vector<int> places(sheets.size());
  for (std::size_t t = 0; t < places.size(); ++t)
    places[t] = sheets[t] * static_cast<int>(count_of_parts) + parts[t];
  return layer_lists(places, count_of_sheets(sheets) * count_of_parts);
}

LayerLists edges_by_sheet(const std::vector<MeshEdge>& edges, const std::vector<int>& sheets) {
  const auto sheet_of = [&sheets](int triangle) {
    return triangle < 0 ? 0 : sheets[static_cast<std::size_t>(triangle)];
  };
  std::vector<int> of_edges;
  of_edges.reserve(edges.size());
  for (const MeshEdge& edge : edges)
    of_edges.push_back(std::max(sheet_of(edge.triangle), sheet_of(edge.other)));
  return layer_lists(of_edges, count_of_sheets(sheets));
}

std::vector<std::vector<int>> vertices_by_sheet(std::span<const std::uint32_t> corners,
                                                const std::vector<int>& sheets) {
  std::vector<int> sheet_of;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (corners[i] >= sheet_of.size()) sheet_of.resize(corners[i] + 1, -1);
    int& sheet = sheet_of[corners[i]];
    sheet = std::max(sheet, sheets[i / 3]);
  }
  std::vector<std::vector<int>> vertices(count_of_sheets(sheets));
  for (std::size_t v = 0; v < sheet_of.size(); ++v)
    if (sheet_of[v] >= 0)
      vertices[static_cast<std::size_t>(sheet_of[v])].push_back(static_cast<int>(v));
  return vertices;
}

}  // namespace foldless
