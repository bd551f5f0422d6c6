// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/snapshot.h"
#include "render/figure_options.h"
#include "render/image.h"

namespace foldless {

/// Draws snapshots off screen, any number of them in one context.
class FigureRenderer {
 public:
  /// In a context of its own. Throws Error when none can be made.
  FigureRenderer();
  /// In the context that is current: every function needs it, and render() leaves another
  /// framebuffer bound.
  struct InCurrentContext {};
  explicit FigureRenderer(InCurrentContext);
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

}  // namespace foldless
