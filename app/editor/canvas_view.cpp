// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/canvas_view.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/editor/handle_view.h"
#include "app/editor/scene_document.h"
#include "core/method/satisfied.h"

namespace foldless {
namespace {

/// Space between what is fitted and the border of the canvas. [design pixels]
constexpr double kMargin = 48;
/// What is shown round a single handle, as a part of the mesh's diagonal.
constexpr double kSurroundings = 0.1;

void extend(Box& box, const Vec2& point, double by = 0) {
  box.min = {std::min(box.min.x, point.x() - by), std::min(box.min.y, point.y() - by)};
  box.max = {std::max(box.max.x, point.x() + by), std::max(box.max.y, point.y() + by)};
}

Box box_at(const Vec2& point) { return {{point.x(), point.y()}, {point.x(), point.y()}}; }

}  // namespace

void CanvasView::resize(int width, int height, double ui_scale) {
  side_pane_.show(beside());  // a pose that is kept later opens no pane by itself
  if (width == canvas_.width && height == canvas_.height && ui_scale == canvas_.ui_scale) return;
  canvas_.width = std::max(width, 1);
  canvas_.height = std::max(height, 1);
  canvas_.ui_scale = ui_scale;
  options_.ui_scale = ui_scale;
  side_pane_.resize(canvas_);
  if (is_fitted_) fit_all();
  messages_.redraw();
}

ViewOptions CanvasView::shown_options() const {
  ViewOptions options = options_;
  options.layers.remeshed = options.layers.remeshed || beside() == Beside::rest_mesh;
  if (overlays_hidden_) {
    const bool fill = options.layers.fill;
    options.layers = {};
    for (const LayerRow& row : kLayerRows) options.layers.*row.shown = false;
    options.layers.fill = fill;
  }
  return options;
}

void CanvasView::set_camera(const Camera& camera) {
  is_fitted_ = false;
  move_camera(camera);
}

void CanvasView::move_camera(const Camera& camera) {
  canvas_.camera = camera;
  side_pane_.follow(camera);
  messages_.redraw();
}

void CanvasView::zoom(double factor) {
  set_camera(zoomed_about(canvas_.camera, canvas_.size(), canvas_.size() / 2.0, factor));
}

double CanvasView::zoom_level() const {
  // The unit of a mesh that was made of an image is the image's pixel.
  const double unit = (draft_.document().texture_box ? 1 : 100) * canvas_.ui_scale;
  return canvas_.camera.pixels_per_unit / unit;
}

void CanvasView::set_zoom_level(double level) {
  if (std::isfinite(level) && level > 0) zoom(level / zoom_level());
}

std::optional<TextureBox> CanvasView::artboard() const {
  const Document& document = draft_.document();
  return document.texture.empty() ? std::nullopt : document.texture_box;
}

void CanvasView::fit_artboard() {
  const auto box = artboard();
  if (!box) return;
  const Box shown{{box->min.x(), box->min.y()}, {box->max.x(), box->max.y()}};
  set_camera(fit_to_box(shown, canvas_.size(), kMargin * canvas_.ui_scale));
}

void CanvasView::fit_all() {
  is_fitted_ = true;
  if (!draft_.shown() || canvas_.width <= 1 || canvas_.height <= 1) return;
  const Snapshot& shown = *draft_.shown();
  Box box = box_at(shown.deformed.col((*shown.triangles)(0, 0)));
  for (const int v : shown.triangles->reshaped()) extend(box, shown.deformed.col(v));
  for (const HandleView& handle : handle_views(draft_)) extend(box, handle.target);
  if (beside() == Beside::kept_pose) {
    const Snapshot& kept = *comparison_.kept();
    for (const int v : kept.triangles->reshaped()) extend(box, kept.deformed.col(v));
    side_pane_.align(fit_to_box(box, canvas_.size(), kMargin * canvas_.ui_scale));
    return move_camera(side_pane_.pane().camera);
  }
  const Camera camera = fit_to_box(box, canvas_.size(), kMargin * canvas_.ui_scale);
  move_camera(side_pane_.fit(*shown.rest, camera, kMargin));
}

void CanvasView::fit_selection() {
  std::vector<HandleView> handles = handle_views(draft_);
  std::erase_if(handles, [](const HandleView& h) { return !h.is_selected; });
  if (handles.empty()) return fit_all();
  const double around = kSurroundings * bounding_box_diagonal(*draft_.shown()->rest);
  Box box = box_at(handles.front().position);
  for (const HandleView& handle : handles) {
    extend(box, handle.position, around);
    extend(box, handle.target, around);
  }
  set_camera(fit_to_box(box, canvas_.size(), kMargin * canvas_.ui_scale));
}

void CanvasView::show_mesh(bool shown) {
  options_.layers.wireframe = options_.layers.boundary = shown;
  messages_.redraw();
}

void CanvasView::hide_overlays(bool hidden) {
  overlays_hidden_ = hidden;
  messages_.redraw();
}

Beside CanvasView::beside() const {
  const Beside content = side_pane_.content();
  return content == Beside::kept_pose && !comparison_.kept() ? Beside::nothing : content;
}

void CanvasView::toggle_beside(Beside content) {
  const Beside before = beside();
  side_pane_.show(before == content ? Beside::nothing : content);
  is_fitted_ = true;  // where the canvas changes its size next, that comes too early
  if (before != Beside::nothing && beside() != Beside::nothing) fit_all();
  messages_.redraw();
}

void CanvasView::toggle_link() {
  if (side_pane_.is_linked())
    side_pane_.unlink();
  else
    side_pane_.link(canvas_.camera);
  messages_.redraw();
}

void CanvasView::set_side_camera(const Camera& camera) {
  is_fitted_ = false;
  canvas_.camera = side_pane_.move(camera, canvas_.camera);
  messages_.redraw();
}

nlohmann::json CanvasView::json() const { return view_json(canvas_.camera, options_); }

void CanvasView::read(const nlohmann::json& json) {
  if (read_view(json, canvas_.camera, options_)) is_fitted_ = false;
}

}  // namespace foldless
