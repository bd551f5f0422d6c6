// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/side_pane.h"

#include <algorithm>

namespace foldless {

void SidePane::link(const Camera& canvas) {
  is_linked_ = true;
  pane_.camera.pixels_per_unit = canvas.pixels_per_unit;
  offset_ = pane_.camera.centre - canvas.centre;
}

void SidePane::resize(const Canvas& canvas) {
  pane_.width = canvas.width;
  pane_.height = canvas.height;
  pane_.ui_scale = canvas.ui_scale;
}

Camera SidePane::fit(const Points& points, const Camera& canvas, double margin) {
  const Vec2 low = points.rowwise().minCoeff(), high = points.rowwise().maxCoeff();
  pane_.camera =
      fit_to_box({{low.x(), low.y()}, {high.x(), high.y()}}, pane_.size(), margin * pane_.ui_scale);
  if (!is_linked_) return canvas;
  Camera fitted = canvas;
  fitted.pixels_per_unit = std::min(canvas.pixels_per_unit, pane_.camera.pixels_per_unit);
  link(fitted);
  return fitted;
}

void SidePane::align(const Camera& canvas) {
  pane_.camera = canvas;
  offset_ = {0, 0};
}

void SidePane::follow(const Camera& canvas) {
  if (is_linked_) pane_.camera = {canvas.centre + offset_, canvas.pixels_per_unit};
}

Camera SidePane::move(const Camera& pane, const Camera& canvas) {
  pane_.camera = pane;
  return is_linked_ ? Camera{pane.centre - offset_, pane.pixels_per_unit} : canvas;
}

}  // namespace foldless
