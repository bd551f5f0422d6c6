// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scenes.h"

#include <glad/gl.h>

#include <algorithm>
#include <utility>

#include "app/gui/canvas_picture.h"
#include "app/gui/preview.h"
#include "core/error.h"
#include "render/theme.h"

namespace foldless {
namespace {

/// Of a picture, that are brought to the graphics card: a few milliseconds.
constexpr std::size_t kPixelsOfAFrame = 1'500'000;

/// Targets belong to the deformed mesh.
Snapshot with_targets_at_rest(Snapshot snapshot) {
  for (Handle& handle : snapshot.handles) handle.target = snapshot.rest->col(handle.vertex);
  return snapshot;
}

HeatRange range_of(const SceneInSight& scene) {
  const ViewOptions& options = scene.options;
  if (options.heat_measure != HeatMeasure::energy)
    return distortion_of(*scene.pose, options.heat_measure).range;
  return distortion_of(energy_densities(*scene.pose, *scene.energy, options)).range;
}

/// One scale for all lanes of a race, and for two poses, so that their colours can be compared.
std::optional<HeatRange> common_range(const Sight& sight) {
  std::optional<HeatRange> common;
  for (const SceneInSight& scene : sight.scenes) {
    if (!scene.shares_heat_scale || !scene.options.layers.heat) continue;
    const HeatRange range = range_of(scene);
    if (!common) common = range;
    if (scene.gives_heat_range)
      common->triangle_at_max = range.max >= common->max ? range.triangle_at_max : kElsewhere;
    common->min = std::min(common->min, range.min);
    common->max = std::max(common->max, range.max);
  }
  return common;
}

}  // namespace

bool Scenes::follow(Editor& editor, const Layout& layout, Extent framebuffer, bool has_squares) {
  const bool has_new_texture = follow_texture(editor);
  Sight sight = sight_of(editor, layout, framebuffer, has_squares);
  const bool has_more_texture = canvas_.upload_texture(kPixelsOfAFrame);
  const bool differs = has_new_texture || has_more_texture || sight != sight_;
  // Else what is drawn again would not be what was drawn last, were a difference overlooked.
  if (differs) sight_ = std::move(sight);
  if (editor.race().is_open()) add_lanes(editor.race().lanes().size());
  return differs;
}

SceneRenderer& Scenes::canvas_renderer() {
  canvas_.upload_texture();
  return canvas_;
}

void Scenes::add_lanes(std::size_t count) {
  while (lanes_.size() < count) {
    lanes_.push_back(std::make_unique<SceneRenderer>());
    if (image_) lanes_.back()->set_texture(*image_, place_);
    lanes_.back()->set_parts(parts_);
  }
}

void Scenes::draw() {
  const glm::vec4 background = canvas_colours(sight_.theme).background;
  glViewport(0, 0, sight_.framebuffer.width, sight_.framebuffer.height);
  glDisable(GL_SCISSOR_TEST);
  glClearColor(background.r, background.g, background.b, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  const auto common = common_range(sight_);
  heat_range_ = common;
  for (const SceneInSight& scene : sight_.scenes) draw(scene, common);
}

void Scenes::draw(const SceneInSight& scene, const std::optional<HeatRange>& common) {
  SceneRenderer& renderer = scene.lane ? *lanes_[*scene.lane] : canvas_;
  ViewOptions options = scene.options;
  if (common) options.heat_scale = {common->min, common->max};
  if (scene.squares) {
    squares_.draw(*scene.squares, {scene.viewport, scene.camera, options.ui_scale}, sight_.theme);
    options.background = Background::keep;
  }
  SceneView view{scene.viewport, scene.camera, scene.selected, scene.hovered};
  if (scene.energy) view.energy_densities = energy_densities(*scene.pose, *scene.energy, options);
  view.stiffness = scene.stiffness;
  if (scene.has_targets_at_rest)
    renderer.draw(with_targets_at_rest(*scene.pose), view, options);
  else
    renderer.draw(*scene.pose, view, options);
  if (scene.gives_heat_range && !common) heat_range_ = renderer.heat_range();
}

bool Scenes::follow_texture(Editor& editor) {
  const auto preview = preview_of(editor);
  const auto image = preview ? preview->image : editor.files().texture_image().image();
  const auto place = box_of(preview ? preview->image_box : editor.document().texture_box);
  const auto& parts = preview ? preview->parts : editor.document().parts;
  const bool has_new_parts = parts != parts_;
  const bool has_new_image = image != image_ || place != place_;
  parts_ = parts;
  canvas_.set_parts(parts_);
  for (const auto& lane : lanes_) lane->set_parts(parts_);
  if (!has_new_image) return has_new_parts;
  image_ = image;
  place_ = place;
  canvas_.clear_texture();
  for (const auto& lane : lanes_) lane->clear_texture();
  if (!image) return true;
  try {
    canvas_.begin_texture(*image, place);
    for (const auto& lane : lanes_) lane->set_texture(*image, place);
  } catch (const Error& error) {
    editor.messages().toast(ToastKind::error, error.what());
  }
  return true;
}

}  // namespace foldless
