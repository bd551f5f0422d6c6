// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/vector_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "render/edge_lines.h"

namespace foldless {
namespace {

constexpr double kFaintest = 0.15;   // as in the shader of lines
constexpr std::size_t kShares = 20;  // steps of opacity; each is one path

/// Which step of opacity an edge has that is so many pixels long.
std::size_t share_of(double pixels, double fade_below) {
  const double share = fade_below > 0 ? std::clamp(pixels / fade_below, kFaintest, 1.0) : 1;
  return static_cast<std::size_t>(std::lround(share * kShares));
}

void stroke_edges(const VectorPane& pane, const PlacedMesh& mesh,
                  const std::vector<MeshEdge>& edges, const LineStyle& style) {
  std::array<std::vector<MeshEdge>, kShares + 1> by_share;
  const double fade_below = style.fade_below * pane.ui_scale;
  for (const MeshEdge& edge : edges) {
    const double pixels = glm::distance(mesh.places[edge.a], mesh.places[edge.b]);
    by_share[share_of(pixels, fade_below)].push_back(edge);
  }
  for (std::size_t step = 0; step <= kShares; ++step) {
    if (by_share[step].empty()) continue;
    for (const MeshEdge& edge : by_share[step])
      add_line(pane, mesh.places[edge.a], mesh.places[edge.b]);
    set_line(pane, style, static_cast<double>(step) / kShares);
    cairo_stroke(pane.cairo);
  }
}

}  // namespace

void draw_edges(const VectorPane& pane, const PlacedMesh& mesh, std::size_t sheet,
                const ViewOptions& style) {
  for (const EdgeLines& lines : edge_lines(style)) {
    const auto set = static_cast<std::size_t>(lines.set);
    const LayerLists& sheets = mesh.edges_by_sheet[set];
    std::vector<MeshEdge> edges;
    for (std::size_t k = sheets.first[sheet]; k < sheets.first[sheet + 1]; ++k)
      edges.push_back(mesh.edges[set][static_cast<std::size_t>(sheets.order[k])]);
    stroke_edges(pane, mesh, edges, lines.style);
  }
}

void draw_outline(const VectorPane& pane, const PlacedMesh& mesh, const LineStyle& style) {
  for (const MeshEdge& edge : mesh.edges[static_cast<std::size_t>(EdgeSet::boundary)])
    add_line(pane, mesh.places[edge.a], mesh.places[edge.b]);
  set_line(pane, style);
  cairo_stroke(pane.cairo);
}

}  // namespace foldless
