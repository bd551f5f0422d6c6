// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/canvas_picture.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "core/error.h"
#include "render/render_target.h"

namespace foldless {
namespace {

std::string exact_words(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.17g", value);
  return text.data();
}

}  // namespace

std::vector<double> energy_densities(const Snapshot& snapshot, const Density& energy,
                                     const ViewOptions& options) {
  std::vector<double> densities;
  if (!options.layers.heat || options.heat_measure != HeatMeasure::energy) return densities;
  densities.reserve(static_cast<std::size_t>(snapshot.triangles->cols()));
  for (const auto& t : snapshot.triangles->colwise())
    densities.push_back(energy.value(deformation_gradient(*snapshot.rest, snapshot.deformed, t)));
  return densities;
}

std::optional<Box> box_of(const std::optional<TextureBox>& box) {
  if (!box) return std::nullopt;
  return Box{{box->min.x(), box->min.y()}, {box->max.x(), box->max.y()}};
}

SceneView scene_view(const Editor& editor, int x, int y) {
  const Canvas& canvas = editor.canvas();
  const auto& selection = editor.selection().ids();
  return {{x, y, canvas.width, canvas.height},
          canvas.camera,
          {selection.begin(), selection.end()},
          editor.selection().hovered()};
}

Layers exported_layers(const Editor& editor) {
  Layers layers = editor.view().shown_options().layers;
  if (!editor.document().texture.empty()) layers.handles = false;
  return layers;
}

std::array<int, 2> size_of_picture(const Editor& editor, const PictureOptions& options) {
  return options.size.value_or(
      std::array{editor.canvas().width * options.factor, editor.canvas().height * options.factor});
}

PictureSetting picture_setting(const Editor& editor, const PictureOptions& options) {
  PictureSetting setting{scene_view(editor, 0, 0), editor.view().shown_options()};
  auto& [view, style] = setting;
  const auto [width, height] = size_of_picture(editor, options);
  const double factor = std::min(static_cast<double>(width) / view.viewport.width,
                                 static_cast<double>(height) / view.viewport.height);
  view.viewport.width = width;
  view.viewport.height = height;
  view.camera.pixels_per_unit *= factor;
  view.selected.clear();
  view.hovered.reset();
  style.layers = options.layers;
  view.energy_densities = energy_densities(*editor.shown(), *editor.document().energy, style);
  style.ui_scale *= factor;
  if (options.is_transparent) style.background = Background::transparent;
  return setting;
}

Image draw_picture(const Editor& editor, SceneRenderer& renderer, const PictureOptions& options) {
  if (!editor.shown()) throw Error("There is no mesh to make a picture of: open one first.");
  const auto [view, style] = picture_setting(editor, options);
  RenderTarget target(view.viewport.width, view.viewport.height);
  target.bind();
  renderer.draw(*editor.shown(), view, style);
  return target.read();
}

FigureOptions figure_of_canvas(const Editor& editor, const PictureOptions& options) {
  PictureSetting setting = picture_setting(editor, options);
  FigureOptions figure;
  figure.width = setting.view.viewport.width;
  figure.height = setting.view.viewport.height;
  figure.view = setting.style.pose == Pose::rest ? FigureView::rest : FigureView::deformed;
  figure.style = setting.style;
  figure.camera = setting.view.camera;
  figure.energy_densities = std::move(setting.view.energy_densities);
  figure.has_legend = false;
  figure.texture = editor.files().texture_image().image();
  figure.parts = editor.document().parts;
  figure.texture_place = box_of(editor.document().texture_box);
  return figure;
}

ImageTexts picture_texts(const Editor& editor) {
  const Document& document = editor.document();
  ImageTexts texts{
      {"Software", "Foldless"},
      {"Scene", editor.files().path().empty() ? document.name : editor.files().path().string()},
      {"Method", document.parameters.method},
      {"Distortion", std::string(document.energy->name)}};
  if (const auto& snapshot = editor.shown(); snapshot && snapshot->iteration) {
    const Playback& playback = editor.playback();
    const std::size_t newest = std::max<std::size_t>(playback.iterations().size(), 1) - 1;
    texts["Iteration"] = std::to_string(playback.scrubbed().value_or(newest) + 1);
    texts["Energy"] = exact_words(snapshot->iteration->energy);
  }
  return texts;
}

std::filesystem::path numbered_picture(const std::filesystem::path& folder,
                                       const std::string& name) {
  std::filesystem::path path;
  std::error_code ignored;
  for (int number = 1; number == 1 || std::filesystem::exists(path, ignored); ++number) {
    std::array<char, 16> suffix{};
    std::snprintf(suffix.data(), suffix.size(), "-%04d.png", number);
    path = folder / (name + suffix.data());
  }
  return path;
}

}  // namespace foldless
