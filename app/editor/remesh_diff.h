// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/canvas.h"
#include "core/snapshot.h"

namespace foldless {

/// The pane with the rest mesh beside the canvas with the deformed one: flipped edges and split
/// vertices in both. Linked panes have one magnification and are moved together.
class RemeshDiff {
 public:
  bool is_shown() const { return is_shown_; }
  void show(bool shown) { is_shown_ = shown; }
  bool is_linked() const { return is_linked_; }
  /// The rest mesh takes the magnification of the deformed one.
  void link(const Camera& deformed);
  void unlink() { is_linked_ = false; }

  /// The pane of the rest mesh; as large as the canvas.
  const Canvas& pane() const { return pane_; }
  void resize(const Canvas& deformed);
  /// Shows the box of the rest mesh, at the magnification of the deformed one when linked; returns
  /// the camera of the deformed one that goes with it.
  Camera fit(const Points& rest, const Camera& deformed, double margin);
  /// The canvas was moved.
  void follow(const Camera& deformed);
  /// The pane was moved; returns the camera of the canvas that goes with it.
  Camera move(const Camera& rest, const Camera& deformed);

 private:
  bool is_shown_ = false;
  bool is_linked_ = true;
  Canvas pane_;
  glm::dvec2 offset_{0, 0};  ///< from the middle of the canvas to the middle of the pane [length]
};

}  // namespace foldless
