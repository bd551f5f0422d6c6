// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <vector>

#include "app/editor/editor.h"
#include "render/figure_options.h"
#include "render/image.h"
#include "render/scene_renderer.h"

namespace foldless {

/// How the canvas is written to a picture.
struct PictureOptions {
  int factor = 1;  ///< pixels of the picture a pixel of the canvas: 1, 2 or 4
  /// Width and height in pixels in place of a factor: what the canvas shows, in the middle.
  std::optional<std::array<int, 2>> size = std::nullopt;
  bool is_transparent = false;
  Layers layers;
};

/// The layers that an export begins with: those on screen, but of a drawing without its handles.
Layers exported_layers(const Editor& editor);

/// Width and height of a picture of the canvas. [pixels]
std::array<int, 2> size_of_picture(const Editor& editor, const PictureOptions& options);

/// What a picture shows, from where and how large; one factor for all that is drawn.
struct PictureSetting {
  SceneView view;
  ViewOptions style;
};
/// Precondition: there is a mesh on screen.
PictureSetting picture_setting(const Editor& editor, const PictureOptions& options);

/// The canvas as the user sees it, drawn anew at the size that is asked for. Needs the renderer's
/// context; leaves framebuffer 0's owner to bind its framebuffer again. Throws Error when the
/// graphics card refuses a picture of this size.
Image draw_picture(const Editor& editor, SceneRenderer& renderer, const PictureOptions& options);

/// The same view as a figure of lines and areas.
FigureOptions figure_of_canvas(const Editor& editor, const PictureOptions& options);

/// What a picture says about itself in its text chunks: scene, method, iteration, energy.
ImageTexts picture_texts(const Editor& editor);

/// The first of `NAME-0001.png`, `NAME-0002.png`, … in `folder` that is not there yet.
std::filesystem::path numbered_picture(const std::filesystem::path& folder,
                                       const std::string& name);

/// ψ(J) of every triangle; empty unless the heat map shows it.
std::vector<double> energy_densities(const Snapshot& snapshot, const Density& energy,
                                     const ViewOptions& options);

/// Where a texture lies, as the renderer wants it.
std::optional<Box> box_of(const std::optional<TextureBox>& box);

/// From where the editor looks, in a viewport of the canvas's size at (x, y) from the lower left.
SceneView scene_view(const Editor& editor, int x, int y);

}  // namespace foldless
