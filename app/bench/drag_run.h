// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stop_token>

#include "app/bench/bench_run.h"
#include "core/run/run.h"

namespace foldless {

/// Moves the targets of a run frame by frame along the drag of its scene and measures how it
/// follows. A frame, whatever the method: new targets, then iterations until every handle is within
/// 1e-6 D of its target, two at most. Before the first frame the run goes to its end at the targets
/// of the scene. Ends early when the token is set, with as many frames as there are.
void run_drag(const BenchJob& job, Run& run, const std::stop_token& token, BenchRow& row);

}  // namespace foldless
