// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/method/method.h"
#include "core/method/normalisation.h"
#include "core/run/goal.h"
#include "core/run/publisher.h"
#include "core/snapshot.h"

namespace foldless {

/// Starts a method on a problem whose rest diagonal is about 1.
using MethodStarter = std::function<std::unique_ptr<Method>(const Problem& problem)>;

/// Starts the method that the problem's parameters name. Throws Error when there is none.
std::unique_ptr<Method> start_method(const Problem& problem);

/// A method on a problem in input units: it solves the active part, normalised, with the Followers
/// of its handles, and a Publisher makes proved snapshots of what it reaches. Where nothing is
/// active the run has ended before it began. Not thread-safe: one thread at a time may call it.
class Run {
 public:
  /// Throws Error when the method is unknown, or when the problem's mesh is not locally injective
  /// or of a size that double precision does not hold.
  explicit Run(const Problem& problem, std::uint64_t generation = 0,
               const MethodStarter& starter = start_method);

  /// One vertex update, its record in input units; see Method::step for cancellation. With s the
  /// scale of normalisation(): energies, ‖∇E‖² and ‖P‖² are divided by s², lengths by s; μ, ratios
  /// and counters are the same in both frames. A mesh that is not locally injective in input units
  /// is not published, unless the method may make it so and its rest mesh is: the record is
  /// returned, but snapshot() stays what it was.
  std::optional<Iteration> step(const std::stop_token& token);
  /// How the run ended; nothing while it can go on.
  std::optional<Outcome> outcome() const;
  /// One sentence on that end where the outcome does not say it all; may be empty.
  std::string verdict() const { return method_ ? method_->verdict() : ""; }
  /// True when snapshot() is valid and has every handle that is not soft at its target, and its
  /// followers: ‖P‖² ≤ 1e-10 D², D of the active part.
  bool is_satisfied() const;

  /// Moves the targets, in the order of the problem's handles (input units, 2 × #handles), and
  /// turns those that turn (degrees, an entry a handle; empty: they stay as they are). From a
  /// folded map the run begins anew at the last valid one.
  void set_targets(const Points& targets, const std::vector<double>& angles = {});
  const std::vector<Handle>& handles() const { return goal_.handles(); }

  /// The last state that was published, with the newest targets; never null. It is valid in input
  /// units, or marked as not when the method may make such.
  std::shared_ptr<const Snapshot> snapshot() const { return snapshot_; }
  /// The problem that goes on from the last valid state.
  Problem resumed() const;
  /// The frame that the method works in.
  const Normalisation& normalisation() const { return publisher_->normalisation(); }
  /// Where the processor time went so far.
  StageTimes times() const { return method_ ? method_->times() : StageTimes(); }

 private:
  /// `part`: of the problem; its handles move nothing else, nor do their followers.
  Run(const Problem& problem, std::uint64_t generation, const MethodStarter& starter,
      ActivePart part);

  std::shared_ptr<const Snapshot> with_handles(const Snapshot& snapshot) const;
  Problem with_followers(Problem problem) const;

  const MethodStarter start_method_;
  const Density* energy_;
  Parameters parameters_;
  std::shared_ptr<const Stiffness> stiffness_;
  OriginalMesh original_;
  Goal goal_;  ///< input units
  std::optional<Publisher> publisher_;
  std::unique_ptr<Method> method_;  ///< null where nothing can move
  std::shared_ptr<const Snapshot> snapshot_;
  std::shared_ptr<const Snapshot> valid_;  ///< the last that was valid
};

/// A record of the normalised problem in input units; see Run::step.
Iteration in_input_units(Iteration iteration, const Normalisation& normalisation);

}  // namespace foldless
