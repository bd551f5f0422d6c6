// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "render/camera.h"
#include "render/texture_pieces.h"
#include "render/view_options.h"

namespace foldless {

/// Which mesh a figure shows.
enum class FigureView { deformed, rest, both };

/// The default look of a figure: everything but the theme, which is light, as in the editor.
inline ViewOptions figure_style() {
  ViewOptions style;
  style.theme = Theme::light;
  return style;
}

/// Red, green, blue.
using GroundColour = std::array<std::uint8_t, 3>;

/// A picture of a snapshot for a file; see `foldless render`.
struct FigureOptions {
  int width = 1200;  ///< pixels
  int height = 900;  ///< pixels
  int samples = 4;   ///< samples a pixel; fewer where the context refuses
  FigureView view = FigureView::deformed;
  ViewOptions style = figure_style();            ///< its pose is set from `view`
  std::shared_ptr<const TexturePieces> texture;  ///< null: the checkerboard
  std::optional<Box> texture_place;              ///< see SceneRenderer::set_texture()
  std::shared_ptr<const MeshParts> parts;        ///< of the mesh; null: none
  std::optional<Box> frame;      ///< world box to show; absent: the mesh and its targets
  std::optional<Camera> camera;  ///< of every pane but a miniature; absent: it shows the frame
  /// Behind the drawing instead of the background of `style`.
  std::optional<GroundColour> ground;
  bool has_legend = true;  ///< beside a heat map
  /// ψ(J) of the triangles, for the heat map of it; see SceneView.
  std::vector<double> energy_densities;
  bool miniature = false;  ///< the deformed mesh once more, small, filled, without its edges
};

}  // namespace foldless
