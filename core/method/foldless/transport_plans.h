// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/method/foldless/transport.h"

namespace foldless {

/// The ways of carrying handles from `starts` to `targets` (2 × #handles) that are worth trying, in
/// that order: together, then staggered, so that handles do not press on each other; along spirals
/// first where they turn together. Then so many orders drawn at random, the same every time: which
/// handle has to go before which cannot be seen from their ways.
std::vector<TransportPlan> transport_plans(const Points& starts, const Points& targets,
                                           int random_orders);

}  // namespace foldless
