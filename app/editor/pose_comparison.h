// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/editor/draft.h"

namespace foldless {

/// Other poses of the mesh, to compare the one on screen with: one that is seen in its place while
/// a key is held, and outlines over it (an onion skin). They are forgotten with the mesh.
class PoseComparison {
 public:
  /// Keeps references.
  PoseComparison(const Draft& draft, Messages& messages) : draft_(draft), messages_(messages) {}

  /// While held, the pose that was kept is seen, or the rest shape where none was.
  void hold(bool is_held) { is_held_ = is_held; }
  bool is_held() const { return is_held_; }
  /// The pose that was kept, or null.
  std::shared_ptr<const Snapshot> kept() const;
  void keep();  ///< what is on screen
  void forget() { kept_.reset(); }

  /// Closed lines of points, one a boundary of the mesh.
  using Outline = std::vector<Points>;
  /// In the order in which they were added.
  std::vector<const Outline*> outlines() const;
  /// Adds the outline of what is on screen, or takes it away where it is there.
  void toggle_outline();
  void clear_outlines() { outlines_.clear(); }
  /// Of any pose.
  static Outline outline_of(const Snapshot& pose);
  bool has_outlines() const { return !outlines().empty(); }

 private:
  struct Pose {
    std::shared_ptr<const Shape> original;
    std::shared_ptr<const Snapshot> shown;
  };
  struct OutlineOfPose {
    Pose pose;
    Outline outline;
  };
  bool is_of_this_mesh(const Pose& pose) const {
    return pose.original == draft_.document().original;
  }

  const Draft& draft_;
  Messages& messages_;
  bool is_held_ = false;
  std::optional<Pose> kept_;
  std::vector<OutlineOfPose> outlines_;
};

}  // namespace foldless
