// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "app/editor/document.h"
#include "core/run/background_frames.h"

namespace foldless {

/// The frames of a document's animation, solved in the background.
class MotionFrames {
 public:
  explicit MotionFrames(std::function<void()> wake) : frames_(std::move(wake)) {}

  /// Solves the document's animation; without one there are no frames.
  void follow(const Document& document);
  void hold(bool is_held) { frames_.hold(is_held); }
  FramesStatus status() const { return frames_.status(); }
  std::shared_ptr<const SolvedFrame> frame(int index) const;
  /// The mesh of a frame as it looks in the document, whose names and depths the solver does not
  /// see; null while it is not solved.
  std::shared_ptr<const Snapshot> pose(const Document& document, int index) const;

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

  BackgroundFrames frames_;
  std::optional<Source> source_;
};

}  // namespace foldless
