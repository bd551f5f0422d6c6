// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <foldless/solve.h>

#include <memory>
#include <optional>
#include <vector>

namespace foldless {

/// A run that goes on from where it is whenever its targets move: targets in, newest valid mesh
/// out. Any thread may call anything. step() and run() come one at a time, others wait for their
/// turn; all else returns at once, also during a run. Sessions do not know of each other.
class Session {
 public:
  /// As solve(), which also says what is thrown; the time limit is that of each run().
  Session(const PointsRef& rest, const TrianglesRef& triangles, const std::vector<int>& handles,
          const PointsRef& targets, const SolveOptions& options = {});
  ~Session();
  Session(Session&& other) noexcept;
  Session& operator=(Session&& other) noexcept;

  /// Where the handles are to go, in their order, #handles × 2, from the next step on. An ended run
  /// can go on then. Throws Error on another shape, or numbers that are not finite.
  void set_targets(const PointsRef& targets);

  /// One vertex update. False when there was none: the run has ended or was cancelled.
  bool step();
  /// Steps to the end. False when it was stopped before, by cancel() or the time limit.
  bool run();
  /// Ends the step() or run() that is under way, or the next one where none is, between two
  /// factorizations: within about a second on a mesh of 100,000 vertices. The last valid mesh
  /// stands, and later calls go on from it.
  void cancel();

  /// The newest valid mesh and what is known of it.
  Result result() const;
  /// M′ of it, #U × 2.
  PointMatrix deformed() const;
  /// M′ has every handle at its newest target.
  bool is_reached() const;
  /// There is nothing left to do for these targets.
  bool has_ended() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace foldless
