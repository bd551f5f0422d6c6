// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/method/method.h"
#include "core/method/normalisation.h"
#include "core/snapshot.h"

namespace foldless {

/// A method on a problem in input units: normalises, steps, and turns what it reaches into
/// snapshots in input units that were proved locally injective with exact predicates.
/// Not thread-safe: one thread at a time may call it.
class Run {
 public:
  /// Throws Error when the method is unknown.
  explicit Run(const Problem& problem, std::uint64_t generation = 0);

  /// One vertex update, its record in input units; see Method::step for cancellation.
  std::optional<Iteration> step(std::stop_token token);
  /// How the run ended; nothing while it can go on.
  std::optional<Outcome> outcome() const;
  /// True when every handle that is not soft is at its target: ‖P‖² ≤ 1e-10 D².
  bool is_satisfied() const;

  /// Moves the targets, in the order of the problem's handles (input units, 2 × #handles).
  void set_targets(const Points& targets);
  const std::vector<Handle>& handles() const { return handles_; }

  /// The last state that is valid in input units; never null.
  std::shared_ptr<const Snapshot> snapshot() const { return snapshot_; }
  /// The frame that the method works in.
  const Normalisation& normalisation() const { return normalisation_; }
};

}  // namespace foldless
