// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/sight.h"

#include <algorithm>
#include <utility>

#include "app/gui/canvas_picture.h"
#include "app/gui/preview.h"
#include "app/gui/race_layout.h"
#include "app/gui/side_dialog.h"

namespace foldless {
namespace {

constexpr float kMargin = 40;  // round the preview of an import, design pixels

Viewport viewport_of(const Rectangle& place, Extent framebuffer) {
  return {static_cast<int>(place.x), framebuffer.height - static_cast<int>(place.y + place.height),
          std::max(1, static_cast<int>(place.width)), std::max(1, static_cast<int>(place.height))};
}

Box box_of(const Points& points) {
  const Vec2 min = points.rowwise().minCoeff();
  const Vec2 max = points.rowwise().maxCoeff();
  return {{min.x(), min.y()}, {max.x(), max.y()}};
}

/// The mesh as it would be, beside the dialog.
SceneInSight preview_scene(const Preview& preview, const Editor& editor, const Layout& layout,
                           Extent framebuffer) {
  const auto scale = static_cast<float>(editor.canvas().ui_scale);
  SceneInSight scene;
  scene.pose = preview.pose;
  scene.viewport = viewport_of(preview_place(layout, scale), framebuffer);
  const Box box = box_of(preview.view_box).value_or(box_of(preview.pose->deformed));
  scene.camera = fit_to_box(box, {scene.viewport.width, scene.viewport.height}, kMargin * scale);
  scene.options = editor.view().options();
  scene.options.layers = preview.layers;
  return scene;
}

SceneInSight at_rest(SceneInSight scene) {
  scene.options.pose = Pose::rest;
  scene.has_targets_at_rest = true;
  return scene;
}

/// Precondition: there is one.
SceneInSight kept_pose(const Editor& editor, SceneInSight scene) {
  scene.pose = editor.comparison().kept();
  return scene;
}

std::vector<SceneInSight> document_scenes(Editor& editor, const Layout& layout,
                                          Extent framebuffer) {
  SceneView view = scene_view(editor, 0, 0);
  SceneInSight scene;
  scene.pose = editor.shown();
  scene.viewport = viewport_of(layout.canvas, framebuffer);
  scene.camera = view.camera;
  scene.selected = std::move(view.selected);
  scene.hovered = view.hovered;
  scene.options = editor.view().shown_options();
  // Never the checkerboard in place of a picture that is still being read.
  if (editor.files().texture_image().is_reading()) scene.options.layers.fill = false;
  scene.energy = editor.document().energy;
  const Beside beside = editor.view().beside();
  scene.shares_heat_scale = beside == Beside::kept_pose;
  std::vector<SceneInSight> scenes;
  if (beside != Beside::nothing) {
    SceneInSight other = beside == Beside::rest_mesh ? at_rest(scene) : kept_pose(editor, scene);
    other.viewport = viewport_of(layout.side, framebuffer);
    other.camera = editor.view().side_pane().pane().camera;
    scenes.push_back(std::move(other));
  }
  if (editor.comparison().is_held()) {
    scenes.push_back(editor.comparison().kept() ? kept_pose(editor, std::move(scene))
                                                : at_rest(std::move(scene)));
    return scenes;
  }
  if (editor.brush().is_tinted()) scene.stiffness = editor.brush().factors();
  scene.gives_heat_range = true;
  scenes.push_back(std::move(scene));
  return scenes;
}

std::vector<SceneInSight> race_scenes(const Editor& editor, const Layout& layout,
                                      Extent framebuffer) {
  const Race& race = editor.race();
  const auto scale = static_cast<float>(race.canvas().ui_scale);
  const RaceLayout places = race_layout_for(layout.canvas, race.lanes().size(), scale);
  std::vector<SceneInSight> scenes;
  for (std::size_t i = 0; i < race.lanes().size(); ++i) {
    SceneInSight scene;
    scene.lane = i;
    scene.pose = race.lanes()[i]->shown();
    scene.viewport = viewport_of(places.lanes[i].view, framebuffer);
    scene.camera = race.canvas().camera;
    scene.options = editor.view().shown_options();
    scene.options.ui_scale = race.canvas().ui_scale;
    scene.energy = editor.document().energy;
    scene.gives_heat_range = scene.shares_heat_scale = true;
    scenes.push_back(std::move(scene));
  }
  return scenes;
}

}  // namespace

Sight sight_of(Editor& editor, const Layout& layout, Extent framebuffer, bool has_squares) {
  Sight sight{framebuffer, editor.view().options().theme, {}};
  if (const auto preview = preview_of(editor)) {
    if (preview->pose) sight.scenes.push_back(preview_scene(*preview, editor, layout, framebuffer));
  } else if (editor.race().is_open()) {
    sight.scenes = race_scenes(editor, layout, framebuffer);
  } else if (editor.shown()) {
    sight.scenes = document_scenes(editor, layout, framebuffer);
    if (has_squares && !editor.view().are_overlays_hidden())
      for (SceneInSight& scene : sight.scenes) scene.squares = box_of(editor.view().artboard());
  }
  return sight;
}

}  // namespace foldless
