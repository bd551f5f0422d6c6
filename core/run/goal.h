// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/run/followers.h"

namespace foldless {

/// Where a run is to bring its handles and what follows them.
class Goal {
 public:
  /// `original`: see Followers. `diagonal`: D of the active part. [length]
  Goal(std::vector<Handle> handles, const Triangles& original, const Points& rest, double diagonal);

  const std::vector<Handle>& handles() const { return handles_; }
  /// The handles, then their followers.
  std::vector<Handle> with_followers() const { return followers_.with_followers(handles_); }
  /// Moves the targets and turns the handles that turn; see Run::set_targets().
  void set_targets(const Points& targets, const std::vector<double>& angles);
  /// True when every handle that is not soft is at its target, and its followers:
  /// ‖P‖² ≤ 1e-10 D².
  bool is_met(const Points& u) const;

 private:
  std::vector<Handle> handles_;
  Followers followers_;
  double diagonal_;  ///< D
};

}  // namespace foldless
