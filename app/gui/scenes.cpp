// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scenes.h"

#include <glad/gl.h>

#include <algorithm>
#include <utility>

#include "app/gui/canvas_picture.h"
#include "app/gui/race_layout.h"
#include "app/gui/side_dialog.h"
#include "core/error.h"
#include "render/theme.h"

namespace foldless {
namespace {

constexpr float kMargin = 40;  // round the preview of an import, design pixels

Viewport viewport_of(const Rectangle& place, Extent framebuffer) {
  return {static_cast<int>(place.x), framebuffer.height - static_cast<int>(place.y + place.height),
          std::max(1, static_cast<int>(place.width)), std::max(1, static_cast<int>(place.height))};
}

/// Targets belong to the deformed mesh.
Snapshot with_targets_at_rest(Snapshot snapshot) {
  for (Handle& handle : snapshot.handles) handle.target = snapshot.rest->col(handle.vertex);
  return snapshot;
}

/// One scale for all lanes, so that their colours can be compared.
std::optional<HeatRange> common_range(const Race& race, const Density& energy,
                                      const ViewOptions& options) {
  std::optional<HeatRange> common;
  for (const auto& lane : race.lanes()) {
    const bool is_of_energy = options.heat_measure == HeatMeasure::energy;
    const HeatRange range =
        is_of_energy ? distortion_of(energy_densities(*lane->shown(), energy, options)).range
                     : distortion_of(*lane->shown(), options.heat_measure).range;
    if (!common) common = range;
    common->min = std::min(common->min, range.min);
    common->max = std::max(common->max, range.max);
  }
  return common;
}

Box box_of(const Points& points) {
  const Vec2 min = points.rowwise().minCoeff();
  const Vec2 max = points.rowwise().maxCoeff();
  return {{min.x(), min.y()}, {max.x(), max.y()}};
}

}  // namespace

void Scenes::draw(Editor& editor, const Layout& layout, Extent framebuffer) {
  follow_texture(editor);
  const glm::vec4 background = canvas_colours(editor.view().options().theme).background;
  glViewport(0, 0, framebuffer.width, framebuffer.height);
  glDisable(GL_SCISSOR_TEST);
  glClearColor(background.r, background.g, background.b, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  heat_range_.reset();
  if (const auto preview = preview_of(editor))
    draw_preview(*preview, editor, layout, framebuffer);
  else if (editor.race().is_open())
    draw_race(editor, layout, framebuffer);
  else if (editor.shown())
    draw_document(editor, layout, framebuffer);
}

/// The mesh as it would be, beside the dialog.
void Scenes::draw_preview(const Preview& preview, const Editor& editor, const Layout& layout,
                          Extent framebuffer) {
  if (!preview.pose) return;
  const auto scale = static_cast<float>(editor.canvas().ui_scale);
  SceneView view;
  view.viewport = viewport_of(preview_place(layout, scale), framebuffer);
  const Box box = box_of(preview.view_box).value_or(box_of(preview.pose->deformed));
  view.camera = fit_to_box(box, {view.viewport.width, view.viewport.height}, kMargin * scale);
  ViewOptions options = editor.view().options();
  options.layers = preview.layers;
  canvas_.draw(*preview.pose, view, options);
}

void Scenes::draw_document(Editor& editor, const Layout& layout, Extent framebuffer) {
  const Snapshot& shown = *editor.shown();
  SceneView view = scene_view(editor, 0, 0);
  ViewOptions options = editor.view().shown_options();
  // Never the checkerboard in place of a picture that is still being read.
  if (editor.files().texture_image().is_reading()) options.layers.fill = false;
  view.energy_densities = energy_densities(shown, *editor.document().energy, options);
  if (editor.view().remesh_diff().is_shown()) {
    SceneView beside = view;
    beside.viewport = viewport_of(layout.rest, framebuffer);
    beside.camera = editor.view().remesh_diff().pane().camera;
    options.pose = Pose::rest;
    canvas_.draw(with_targets_at_rest(shown), beside, options);
    options.pose = Pose::deformed;
  }
  view.viewport = viewport_of(layout.canvas, framebuffer);
  if (editor.comparison().is_held()) return draw_other_pose(editor, view, options);
  if (editor.brush().is_tinted()) view.stiffness = editor.brush().factors();
  canvas_.draw(shown, view, options);
  heat_range_ = canvas_.heat_range();
}

/// What is compared with, in place of the newest.
void Scenes::draw_other_pose(const Editor& editor, SceneView view, ViewOptions options) {
  if (const auto kept = editor.comparison().kept()) {
    view.energy_densities = energy_densities(*kept, *editor.document().energy, options);
    return canvas_.draw(*kept, view, options);
  }
  options.pose = Pose::rest;
  canvas_.draw(with_targets_at_rest(*editor.shown()), view, options);
}

void Scenes::draw_race(const Editor& editor, const Layout& layout, Extent framebuffer) {
  const Race& race = editor.race();
  while (lanes_.size() < race.lanes().size()) {
    lanes_.push_back(std::make_unique<SceneRenderer>());
    if (image_) lanes_.back()->set_texture(*image_, place_);
    lanes_.back()->set_parts(parts_);
  }
  ViewOptions options = editor.view().shown_options();
  options.ui_scale = race.canvas().ui_scale;
  const Density& energy = *editor.document().energy;
  if (options.layers.heat) heat_range_ = common_range(race, energy, options);
  if (heat_range_) options.heat_scale = {heat_range_->min, heat_range_->max};
  const RaceLayout places = race_layout_for(layout.canvas, race.lanes().size(),
                                            static_cast<float>(race.canvas().ui_scale));
  for (std::size_t i = 0; i < race.lanes().size(); ++i) {
    SceneView view;
    view.viewport = viewport_of(places.lanes[i].view, framebuffer);
    view.camera = race.canvas().camera;
    const Snapshot& lane = *race.lanes()[i]->shown();
    view.energy_densities = energy_densities(lane, energy, options);
    lanes_[i]->draw(lane, view, options);
  }
}

void Scenes::follow_texture(Editor& editor) {
  const auto preview = preview_of(editor);
  const auto image = preview ? preview->image : editor.files().texture_image().image();
  const auto place = box_of(preview ? preview->image_box : editor.document().texture_box);
  parts_ = preview ? preview->parts : editor.document().parts;
  canvas_.set_parts(parts_);
  for (const auto& lane : lanes_) lane->set_parts(parts_);
  if (image == image_ && place == place_) return;
  image_ = image;
  place_ = place;
  canvas_.clear_texture();
  for (const auto& lane : lanes_) lane->clear_texture();
  if (!image) return;
  try {
    canvas_.set_texture(*image, place);
    for (const auto& lane : lanes_) lane->set_texture(*image, place);
  } catch (const Error& error) {
    editor.messages().toast(ToastKind::error, error.what());
  }
}

}  // namespace foldless
