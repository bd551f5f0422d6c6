// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/method/foldless/workspace.h"

namespace foldless {

/// Where the handles stop on their way from where they are to their targets, 2 × #handles each; the
/// last stop is the targets. Handles of a part that turn together by a right angle or more go in
/// legs of 60° at most, each on its spiral: on straight ways those that turn by 180° would meet in
/// a point. The others go straight beside them, in as many legs.
std::vector<Points> legs_of(const Workspace& work);

/// So many on straight ways.
std::vector<Points> straight_legs(const Workspace& work, int count);

}  // namespace foldless
