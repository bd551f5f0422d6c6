// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/method/method.h"
#include "core/motion/animation.h"
#include "core/snapshot.h"

namespace foldless {

/// A moment of an animation, solved.
struct SolvedFrame {
  double frame = 0;                          ///< the moment, in frames from the start
  std::shared_ptr<const Snapshot> snapshot;  ///< valid
  bool is_satisfied = false;                 ///< every handle that is not soft is at its target
  std::string verdict;                       ///< of the method; may be empty
};

/// Solves the frames of an animation, each from the mesh of one before it. A frame depends on that
/// mesh and on its moment alone, so that frames which are solved again have the same bytes, and
/// that those before a change are still right.
class Frames {
 public:
  /// `at_rest`: the mesh that frame 0 is solved from. What the handles' tracks leave open is as the
  /// problem says.
  Frames(Problem at_rest, Animation animation);

  const Animation& animation() const { return animation_; }
  /// The handles at a moment.
  std::vector<Handle> handles(double frame) const {
    return handles_at(animation_, at_rest_.handles, frame);
  }
  /// The moment `frame` from `before`; from the mesh at rest when that is null. Nothing when the
  /// token was set before it was done. Throws Error as Run.
  std::optional<SolvedFrame> solve(double frame, const Snapshot* before,
                                   const std::stop_token& token) const {
    return solve(frame, before, token, [](const auto&) {});
  }
  /// The same; `visit` sees every state on the way, the last included.
  using Visit = std::function<void(const std::shared_ptr<const Snapshot>&)>;
  std::optional<SolvedFrame> solve(double frame, const Snapshot* before,
                                   const std::stop_token& token, const Visit& visit) const;

 private:
  Problem problem_at(double frame, const Snapshot* before) const;

  Problem at_rest_;
  Animation animation_;
};

}  // namespace foldless
