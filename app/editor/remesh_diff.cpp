// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/remesh_diff.h"

#include <algorithm>

namespace foldless {

void RemeshDiff::link(const Camera& deformed) {
  is_linked_ = true;
  pane_.camera.pixels_per_unit = deformed.pixels_per_unit;
  offset_ = pane_.camera.centre - deformed.centre;
}

void RemeshDiff::resize(const Canvas& deformed) {
  pane_.width = deformed.width;
  pane_.height = deformed.height;
  pane_.ui_scale = deformed.ui_scale;
}

Camera RemeshDiff::fit(const Points& rest, const Camera& deformed, double margin) {
  const Vec2 low = rest.rowwise().minCoeff(), high = rest.rowwise().maxCoeff();
  pane_.camera =
      fit_to_box({{low.x(), low.y()}, {high.x(), high.y()}}, pane_.size(), margin * pane_.ui_scale);
  if (!is_linked_) return deformed;
  Camera canvas = deformed;
  canvas.pixels_per_unit = std::min(canvas.pixels_per_unit, pane_.camera.pixels_per_unit);
  link(canvas);
  return canvas;
}

void RemeshDiff::follow(const Camera& deformed) {
  if (is_linked_) pane_.camera = {deformed.centre + offset_, deformed.pixels_per_unit};
}

Camera RemeshDiff::move(const Camera& rest, const Camera& deformed) {
  pane_.camera = rest;
  return is_linked_ ? Camera{rest.centre - offset_, rest.pixels_per_unit} : deformed;
}

}  // namespace foldless
