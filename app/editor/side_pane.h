// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/canvas.h"
#include "core/snapshot.h"

namespace foldless {

/// What lies at the left of the canvas, as large as it.
enum class Beside {
  nothing,
  rest_mesh,  ///< flipped edges and split vertices in both
  kept_pose   ///< see PoseComparison
};

/// The pane beside the canvas. Linked panes have one magnification and are moved together.
class SidePane {
 public:
  Beside content() const { return content_; }
  void show(Beside content) { content_ = content; }
  bool is_linked() const { return is_linked_; }
  /// The pane takes the magnification of the canvas.
  void link(const Camera& canvas);
  void unlink() { is_linked_ = false; }

  const Canvas& pane() const { return pane_; }
  void resize(const Canvas& canvas);
  /// Shows the box of these points, at the magnification of the canvas when linked; returns the
  /// camera of the canvas that goes with it.
  Camera fit(const Points& points, const Camera& canvas, double margin);
  /// Shows the same part of the plane as the canvas.
  void align(const Camera& canvas);
  /// The canvas was moved.
  void follow(const Camera& canvas);
  /// The pane was moved; returns the camera of the canvas that goes with it.
  Camera move(const Camera& pane, const Camera& canvas);

 private:
  Beside content_ = Beside::nothing;
  bool is_linked_ = true;
  Canvas pane_;
  glm::dvec2 offset_{0, 0};  ///< from the middle of the canvas to the middle of the pane [length]
};

}  // namespace foldless
