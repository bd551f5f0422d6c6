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

void stroke_edges(const VectorPane& pane, const PlacedMesh& mesh, std::span<const MeshEdge> edges,
                  const std::vector<int>& order, const LineStyle& style) {
  std::array<std::vector<int>, kShares + 1> by_share;
  const double fade_below = style.fade_below * pane.ui_scale;
  for (const int e : order) {
    const MeshEdge& edge = edges[static_cast<std::size_t>(e)];
    const double pixels = glm::distance(mesh.places[edge.a], mesh.places[edge.b]);
    by_share[share_of(pixels, fade_below)].push_back(e);
  }
  for (std::size_t step = 0; step <= kShares; ++step) {
    if (by_share[step].empty()) continue;
    for (const int e : by_share[step]) {
      const MeshEdge& edge = edges[static_cast<std::size_t>(e)];
      add_line(pane, mesh.places[edge.a], mesh.places[edge.b]);
    }
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
    const auto first = sheets.order.begin();
    const std::vector<int> order(first + static_cast<std::ptrdiff_t>(sheets.first[sheet]),
                                 first + static_cast<std::ptrdiff_t>(sheets.first[sheet + 1]));
    stroke_edges(pane, mesh, mesh.edges[set], order, lines.style);
  }
}

void draw_outline(const VectorPane& pane, const PlacedMesh& mesh, const LineStyle& style) {
  for (const MeshEdge& edge : mesh.edges[static_cast<std::size_t>(EdgeSet::boundary)])
    add_line(pane, mesh.places[edge.a], mesh.places[edge.b]);
  set_line(pane, style);
  cairo_stroke(pane.cairo);
}

}  // namespace foldless
