// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/figure_panes.h"

#include <algorithm>
#include <glm/common.hpp>
#include <limits>

#include "render/legend.h"

namespace foldless {
namespace {

constexpr double kMargin = 28;  // design pixels round the mesh, room for half a handle

void include(Box& box, double x, double y) {
  box.min = glm::min(box.min, glm::dvec2(x, y));
  box.max = glm::max(box.max, glm::dvec2(x, y));
}

void include(Box& box, const Points& points) {
  for (const auto& p : points.colwise()) include(box, p.x(), p.y());
}

constexpr Layers kMiniatureLayers{.wireframe = false, .handles = false};
/// Of the longer side of a pane.
constexpr double kMiniature = 0.3;

/// Takes the miniature's part off a pane that shows the deformed mesh.
FigurePane cut_off_miniature(FigurePane& pane) {
  const Viewport whole = pane.viewport;
  const bool is_tall = whole.height > whole.width;
  const int part = static_cast<int>(kMiniature * std::max(whole.width, whole.height));
  Viewport small = whole;
  if (is_tall) {
    small.height = part;
    pane.viewport.y += part;
    pane.viewport.height -= part;
  } else {
    small.width = part;
    small.x += whole.width - part;
    pane.viewport.width -= part;
  }
  FigurePane miniature{small, {}, pane.style, true};
  miniature.style.layers = kMiniatureLayers;
  return miniature;
}

std::vector<FigurePane> large_panes_of(const FigureOptions& options, int width) {
  const auto pane = [&options](Pose pose, int left, int pane_width) {
    FigurePane made{{left, 0, pane_width, options.height}, {}, options.style, false};
    made.style.pose = pose;
    made.style.background = Background::keep;
    return made;
  };
  const int half = width / 2;
  switch (options.view) {
    case FigureView::rest: return {pane(Pose::rest, 0, width)};
    case FigureView::both:
      return {pane(Pose::rest, 0, half), pane(Pose::deformed, half, width - half)};
    default: return {pane(Pose::deformed, 0, width)};
  }
}

std::vector<FigurePane> all_panes_of(const FigureOptions& options) {
  const bool has_legend = options.has_legend && options.style.layers.heat;
  const int legend = has_legend ? legend_width(options.style.ui_scale) : 0;
  std::vector<FigurePane> panes = large_panes_of(options, std::max(options.width - legend, 1));
  if (options.miniature && panes.back().style.pose == Pose::deformed) {
    const FigurePane small = cut_off_miniature(panes.back());
    panes.push_back(small);
  }
  return panes;
}

/// A camera a pane, all but that of a miniature at one scale, so that sizes can be compared.
void set_cameras(std::vector<FigurePane>& panes, const Snapshot& snapshot,
                 const FigureOptions& options) {
  double scale = std::numeric_limits<double>::infinity();
  for (FigurePane& pane : panes) {
    const FigureView view = pane.style.pose == Pose::rest ? FigureView::rest : FigureView::deformed;
    const Box box = options.frame ? *options.frame : frame_of(snapshot, view);
    pane.camera = fit_to_box(box, {pane.viewport.width, pane.viewport.height},
                             kMargin * options.style.ui_scale);
    if (!pane.is_miniature) scale = std::min(scale, pane.camera.pixels_per_unit);
  }
  for (FigurePane& pane : panes) {
    if (pane.is_miniature) continue;
    pane.camera.pixels_per_unit = scale;
    if (options.camera) pane.camera = *options.camera;
  }
}

}  // namespace

Box frame_of(const Snapshot& snapshot, FigureView view) {
  const Points& first = view == FigureView::deformed ? snapshot.deformed : *snapshot.rest;
  if (first.cols() == 0) return {};
  const glm::dvec2 corner(first(0, 0), first(1, 0));
  Box box{corner, corner};
  include(box, first);
  if (view == FigureView::both) include(box, snapshot.deformed);
  for (const Handle& handle : snapshot.handles) include(box, handle.target.x(), handle.target.y());
  return box;
}

std::vector<FigurePane> figure_panes(const Snapshot& snapshot, const FigureOptions& options) {
  std::vector<FigurePane> panes = all_panes_of(options);
  set_cameras(panes, snapshot, options);
  return panes;
}

}  // namespace foldless
