// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "core/snapshot.h"
#include "render/camera.h"
#include "render/image.h"
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
  bool miniature = false;        ///< the deformed mesh once more, small, filled, without its edges
};

/// Draws snapshots off screen, any number of them in one context.
class FigureRenderer {
 public:
  /// Throws Error when no context can be made.
  FigureRenderer();
  ~FigureRenderer();
  FigureRenderer(const FigureRenderer&) = delete;
  FigureRenderer& operator=(const FigureRenderer&) = delete;

  /// `both` shows the rest mesh with its constrained vertices green at the left, and the deformed
  /// mesh with its targets red at the right. The heat layer comes with a legend. A miniature stands
  /// below or beside the deformed mesh, where the pane is the longer. Throws Error on a size that
  /// cannot be made.
  Image render(const Snapshot& snapshot, const FigureOptions& options);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// One figure; see FigureRenderer.
Image render_figure(const Snapshot& snapshot, const FigureOptions& options);

/// The box of the deformed mesh, the rest mesh, or both, with the targets of the handles.
Box frame_of(const Snapshot& snapshot, FigureView view);

}  // namespace foldless
