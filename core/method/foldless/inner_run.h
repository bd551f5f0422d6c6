// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/method/stepped_method.h"
#include "core/method/steps.h"

namespace foldless {

/// Steps of a run on another problem up to its end. Its records get this phase; what it spends is
/// added to `effort`, of the run that it is a part of.
Steps<> run_inside(SteppedMethod& run, Phase phase, Effort& effort);

/// The same steps; their records get this phase.
Steps<> in_phase(Phase phase, Steps<> steps);

}  // namespace foldless
