// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/method/handle_paths.h"

namespace foldless {

/// One way of carrying the handles to their targets.
struct TransportPlan {
  PathKind path = PathKind::straight;
  /// Groups of handles that travel together, one group after the other.
  std::vector<std::vector<int>> groups;
  double stride = 0.05;  ///< how far a handle is moved at a time [D]
};

/// The ways of carrying handles from `starts` to `targets` (2 × #handles) that are worth trying, in
/// that order: together, then staggered, so that handles do not press on each other; along spirals
/// first where they turn together. Then so many orders drawn at random, the same every time: which
/// handle has to go before which cannot be seen from their ways.
std::vector<TransportPlan> transport_plans(const Points& starts, const Points& targets,
                                           int random_orders);

/// Whether handles turn about a common centre: such are carried along spirals first.
bool turn_together(const Points& starts, const Points& targets);

/// How handles go on from where a transport locked, round after round: along lines, together and
/// one after the other by turns, in strides that are shorter every second time.
TransportPlan plan_of_round(int round, const Points& starts, const Points& targets);

}  // namespace foldless
