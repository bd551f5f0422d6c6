// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/method/foldless/transport_plans.h"
#include "core/method/foldless/workspace.h"

namespace foldless {

/// Where the handles of a plan are to be at the end of a stride. `work` outlives it.
class Strides {
 public:
  Strides(const Workspace& work, const TransportPlan& plan);

  /// The aim of all handles, 2 × #handles.
  const Points& aims() const { return aims_; }
  double stride() const { return stride_; }  ///< [length]

  /// The next stride of the handles of a group that have made their last one. Handles on straight
  /// paths go on by themselves; those that turn keep step, so that what lies between them turns
  /// like a rigid body.
  void begin(const std::vector<int>& group);

  bool have_arrived(const std::vector<int>& group) const;
  /// At the ends of their paths.
  bool are_home(const std::vector<int>& group) const;
  /// Σ of the distances to go. [length]
  double distance(const std::vector<int>& group) const;
  /// Of the handles that are well behind.
  std::vector<MovingDirection> directions(const std::vector<int>& group) const;

 private:
  bool has_arrived(int handle) const;
  Vec2 to_aim(int handle) const;

  const Workspace& work_;
  double stride_;
  HandlePaths paths_;
  std::vector<double> lambda_;  ///< by handle: where on its path the stride ends
  Points aims_;
};

/// A group locks after too many strides in a row that gained nothing.
class Patience {
 public:
  /// Whether a stride brought the handles a good deal nearer to its end: from one distance() to
  /// another.
  bool gains(double before, double after);
  bool has_run_out() const;

 private:
  int strides_without_gain_ = 0;
};

}  // namespace foldless
