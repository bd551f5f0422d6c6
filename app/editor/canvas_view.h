// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "app/editor/canvas.h"
#include "app/editor/draft.h"
#include "app/editor/messages.h"
#include "app/editor/pose_comparison.h"
#include "app/editor/side_pane.h"
#include "render/view_options.h"

namespace foldless {

/// How a draft is seen: camera, layers, what lies beside it.
class CanvasView {
 public:
  /// Keeps references.
  CanvasView(const Draft& draft, const PoseComparison& comparison, Messages& messages)
      : draft_(draft), comparison_(comparison), messages_(messages) {}

  const Canvas& canvas() const { return canvas_; }
  /// Size of the canvas in framebuffer pixels and framebuffer pixels in one design pixel. What was
  /// fitted and not moved since is fitted again.
  void resize(int width, int height, double ui_scale);

  /// As the user set them; change them freely.
  ViewOptions& options() { return options_; }
  const ViewOptions& options() const { return options_; }
  /// Those to draw with: the user's, without overlays while H is held.
  ViewOptions shown_options() const;
  /// Edges and outline of the mesh, or the picture alone.
  void show_mesh(bool shown);
  void toggle_mesh() { show_mesh(!is_mesh_shown()); }
  bool is_mesh_shown() const { return options_.layers.wireframe || options_.layers.boundary; }
  void hide_overlays(bool hidden);
  bool are_overlays_hidden() const { return overlays_hidden_; }

  void set_camera(const Camera& camera);
  void fit_all();
  void fit_selection();
  /// The canvas that a drawing was painted on; nothing: there is none.
  std::optional<TextureBox> artboard() const;
  void fit_artboard();
  void zoom(double factor);  ///< about the middle of the canvas
  /// 1: 100 design pixels a unit of length; one a pixel of the image where a mesh was made of one.
  double zoom_level() const;
  /// Kept within what a camera can do; what is no positive number is passed over.
  void set_zoom_level(double level);
  void actual_size() { set_zoom_level(1); }

  // The pane beside the canvas.

  const SidePane& side_pane() const { return side_pane_; }
  /// What is seen in it: no kept pose where there is none of this mesh.
  Beside beside() const;
  /// Shows that, or nothing where it was shown.
  void toggle_beside(Beside content);
  void toggle_link();
  /// Moves the pane, and the canvas with it when they are linked.
  void set_side_camera(const Camera& camera);

  /// What a scene file keeps of it.
  nlohmann::json json() const;
  void read(const nlohmann::json& json);

 private:
  void move_camera(const Camera& camera);

  const Draft& draft_;
  const PoseComparison& comparison_;
  Messages& messages_;
  Canvas canvas_;
  bool is_fitted_ = true;  ///< by fit_all(), and stays so when the canvas changes
  ViewOptions options_;
  bool overlays_hidden_ = false;
  SidePane side_pane_;
};

}  // namespace foldless
