// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assets/make/sample_meshes.h"
#include "core/scene/scene.h"

namespace foldless::samples {

/// The gingerbread figure walks, in a loop.
Scene walk(const SampleMesh& gingerbread);
/// The alligator lifts its tail, opens its jaws and snaps.
Scene snap(const SampleMesh& alligator);
/// A disk that is turned by 360° at its rim; a ring inside lags behind and then overtakes the rim.
Scene turn_by_360(const SampleMesh& disk);

}  // namespace foldless::samples
