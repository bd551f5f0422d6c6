// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/figure.h"

#include <algorithm>
#include <glm/common.hpp>
#include <limits>
#include <optional>
#include <vector>

#include "render/legend.h"
#include "render/offscreen.h"
#include "render/render_target.h"
#include "render/scene_renderer.h"

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

/// A pane of the figure: which mesh, and where.
struct Pane {
  Pose pose;
  Viewport viewport;
  bool is_miniature = false;
};

/// Takes the miniature's part off a pane that shows the deformed mesh.
Pane cut_off_miniature(Pane& pane) {
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
  return {pane.pose, small, true};
}

std::vector<Pane> large_panes_of(const FigureOptions& options, int width) {
  const int half = width / 2;
  switch (options.view) {
    case FigureView::rest: return {{Pose::rest, {0, 0, width, options.height}}};
    case FigureView::both:
      return {{Pose::rest, {0, 0, half, options.height}},
              {Pose::deformed, {half, 0, width - half, options.height}}};
    default: return {{Pose::deformed, {0, 0, width, options.height}}};
  }
}

std::vector<Pane> panes_of(const FigureOptions& options, int width) {
  std::vector<Pane> panes = large_panes_of(options, width);
  if (options.miniature && panes.back().pose == Pose::deformed) {
    const Pane small = cut_off_miniature(panes.back());
    panes.push_back(small);
  }
  return panes;
}

/// A camera a pane, all but that of a miniature at one scale, so that sizes can be compared.
std::vector<Camera> cameras_of(const Snapshot& snapshot, const FigureOptions& options,
                               const std::vector<Pane>& panes) {
  std::vector<Camera> cameras;
  double scale = std::numeric_limits<double>::infinity();
  for (const Pane& pane : panes) {
    const FigureView view = pane.pose == Pose::rest ? FigureView::rest : FigureView::deformed;
    const Box box = options.frame ? *options.frame : frame_of(snapshot, view);
    cameras.push_back(fit_to_box(box, {pane.viewport.width, pane.viewport.height},
                                 kMargin * options.style.ui_scale));
    if (!pane.is_miniature) scale = std::min(scale, cameras.back().pixels_per_unit);
  }
  for (std::size_t i = 0; i < panes.size(); ++i) {
    if (panes[i].is_miniature) continue;
    cameras[i].pixels_per_unit = scale;
    if (options.camera) cameras[i] = *options.camera;
  }
  return cameras;
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

struct FigureRenderer::Parts {
  ~Parts() { context.make_current(); }

  void fit_target(const FigureOptions& options);
  void fit_texture(const FigureOptions& options);

  Offscreen context{1, 1, 1};
  SceneRenderer scene;
  std::optional<RenderTarget> target;
  int samples_asked = 0;
  std::shared_ptr<const TexturePieces> texture;
  std::optional<Box> texture_place;
};

void FigureRenderer::Parts::fit_target(const FigureOptions& options) {
  const bool fits = target && target->width() == options.width &&
                    target->height() == options.height && samples_asked == options.samples;
  if (!fits) target.emplace(options.width, options.height, options.samples);
  samples_asked = options.samples;
  target->bind();
}

void FigureRenderer::Parts::fit_texture(const FigureOptions& options) {
  if (texture == options.texture && texture_place == options.texture_place) return;
  options.texture ? scene.set_texture(*options.texture, options.texture_place)
                  : scene.clear_texture();
  texture = options.texture;
  texture_place = options.texture_place;
}

FigureRenderer::FigureRenderer() : parts_(std::make_unique<Parts>()) {}
FigureRenderer::~FigureRenderer() = default;

Image FigureRenderer::render(const Snapshot& snapshot, const FigureOptions& options) {
  parts_->context.make_current();
  parts_->fit_target(options);
  parts_->fit_texture(options);
  parts_->scene.set_parts(options.parts);
  ViewOptions style = options.style;
  const int legend = style.layers.heat ? legend_width(style.ui_scale) : 0;
  const Viewport whole{0, 0, options.width, options.height};
  parts_->scene.draw({}, {.viewport = whole}, style);
  style.background = Background::keep;
  const std::vector<Pane> panes = panes_of(options, std::max(options.width - legend, 1));
  const std::vector<Camera> cameras = cameras_of(snapshot, options, panes);
  for (std::size_t i = 0; i < panes.size(); ++i) {
    style.pose = panes[i].pose;
    if (panes[i].is_miniature) style.layers = kMiniatureLayers;
    parts_->scene.draw(snapshot, {panes[i].viewport, cameras[i], {}, {}}, style);
  }
  Image image = parts_->target->read();
  if (const auto& range = parts_->scene.heat_range()) draw_legend(image, *range, style);
  return image;
}

Image render_figure(const Snapshot& snapshot, const FigureOptions& options) {
  return FigureRenderer().render(snapshot, options);
}

}  // namespace foldless
