// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "app/editor/editor.h"
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

void Editor::select(std::set<int> ids) {
  if (ids == selection_) return;
  selection_ = std::move(ids);
  prune_selection();
  redraw();
}

void Editor::select_all() {
  std::set<int> ids;
  for (const Handle& handle : document_.handles) ids.insert(handle.id);
  select(std::move(ids));
}

void Editor::invert_selection() {
  std::set<int> ids;
  for (const Handle& handle : document_.handles)
    if (!selection_.contains(handle.id)) ids.insert(handle.id);
  select(std::move(ids));
}

void Editor::prune_selection() {
  std::erase_if(selection_, [this](int id) { return !find_handle(document_, id); });
  if (hovered_ && !find_handle(document_, *hovered_)) hovered_.reset();
}

void Editor::set_hovered(std::optional<int> id) {
  if (std::exchange(hovered_, id) != id) redraw();
}

void Editor::set_camera(const Camera& camera) {
  canvas_.camera = camera;
  remesh_diff_.follow(camera);
  redraw();
}

void Editor::zoom(double factor) {
  set_camera(zoomed_about(canvas_.camera, canvas_.size(), canvas_.size() / 2.0, factor));
}

void Editor::actual_size() {
  Camera camera = canvas_.camera;
  // The unit of a mesh that was made of an image is the image's pixel.
  camera.pixels_per_unit = (document_.texture_box ? 1 : 100) * canvas_.ui_scale;
  set_camera(camera);
}

void Editor::fit_all() {
  needs_fit_ = canvas_.width <= 1 || canvas_.height <= 1;
  if (!shown_ || needs_fit_) return;
  Box box = box_at(shown_->deformed.col((*shown_->triangles)(0, 0)));
  for (const int v : shown_->triangles->reshaped()) extend(box, shown_->deformed.col(v));
  for (const HandleView& handle : handle_views()) extend(box, handle.target);
  const Camera camera = fit_to_box(box, canvas_.size(), kMargin * canvas_.ui_scale);
  set_camera(remesh_diff_.fit(*shown_->rest, camera, kMargin));
}

void Editor::fit_selection() {
  std::vector<HandleView> handles = handle_views();
  std::erase_if(handles, [](const HandleView& h) { return !h.is_selected; });
  if (handles.empty()) return fit_all();
  const double around = kSurroundings * bounding_box_diagonal(*shown_->rest);
  Box box = box_at(handles.front().position);
  for (const HandleView& handle : handles) {
    extend(box, handle.position, around);
    extend(box, handle.target, around);
  }
  set_camera(fit_to_box(box, canvas_.size(), kMargin * canvas_.ui_scale));
}

void Editor::show_mesh(bool shown) {
  view_.layers.wireframe = view_.layers.boundary = shown;
  redraw();
}

void Editor::hide_overlays(bool hidden) {
  overlays_hidden_ = hidden;
  redraw();
}

}  // namespace foldless
