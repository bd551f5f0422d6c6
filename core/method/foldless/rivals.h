// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/method/foldless/other_ways.h"
#include "core/method/foldless/workspace.h"
#include "core/method/steps.h"

namespace foldless {

/// Ways that are tried after a cut of a free boundary arrived, which is quick and often not the
/// best: the next cut, and others until one of them arrives uncrushed or all have taken so many
/// factorizations. All hop. One with less E_d, within most_distortion_beside() the first, takes the
/// place.
inline constexpr int kMostOfRivals = 2000;
Steps<> try_rivals(Workspace& work, OtherWays& ways);

}  // namespace foldless
