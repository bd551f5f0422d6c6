// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/editor/document.h"
#include "core/run/background_frames.h"
#include "core/run/background_moment.h"

namespace foldless {

/// What the frames of a document's animation are solved from. Precondition: it has one, and is not
/// empty.
AnimationToSolve animation_to_solve(const Document& document);

/// The mesh of a solved moment as it looks in the document, whose names and depths the solver does
/// not see. Precondition: the document has an animation.
std::shared_ptr<const Snapshot> pose_of(const Document& document, const SolvedFrame& solved);

/// The frames of a document's animation, solved in the background.
class MotionFrames {
 public:
  explicit MotionFrames(const std::function<void()>& wake) : frames_(wake), moment_(wake) {}

  /// Solves the document's animation; without one there are no frames.
  void follow(const Document& document);
  void hold(bool is_held) { frames_.hold(is_held); }
  FramesStatus status() const { return frames_.status(); }
  std::shared_ptr<const SolvedFrame> frame(int index) const;
  /// A moment of [0, cycle.frames) that is no frame, solved from the frame before it; null while it
  /// is not.
  std::shared_ptr<const SolvedFrame> between(double moment);
  /// What solves them; null without frames.
  const std::shared_ptr<const Frames>& solver() const { return solver_; }
  /// All frames as the solver left them, which takes no memory; none while they are not done.
  std::vector<SolvedFrame> solved() const;
  /// The same with the meshes of pose_of().
  std::vector<SolvedFrame> all(const Document& document) const;

 private:
  /// What of a document the frames follow from; large parts by their addresses.
  struct Source {
    std::shared_ptr<const Shape> original;
    std::shared_ptr<const Stiffness> stiffness;
    std::vector<Handle> handles;
    std::shared_ptr<const Animation> animation;
    const Density* energy = nullptr;
    Parameters parameters;
    bool operator==(const Source&) const = default;
  };

  void clear();

  BackgroundFrames frames_;
  BackgroundMoment moment_;
  std::shared_ptr<const Frames> solver_;
  std::optional<Source> source_;
};

}  // namespace foldless
