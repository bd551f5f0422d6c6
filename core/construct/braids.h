// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/construct/slits.h"

namespace foldless {

/// Cuts both disks as slit_open() does, but chooses the class of maps as a braid [Art47]: the
/// points inside go to their places, each on its way and in its time, and take the disk with them.
/// Motions are sought, at random but the same every time, after which the edges of a triangulation
/// of the disk at rest, which go with it, cost as little as possible, see CurveEnergy. `search`:
/// which of the random searches, from 0. Triangles are not given. Nothing where no motion that was
/// tried stays in the disk, an outline bounds no disk, or a point is not inside, or the disk lies
/// over itself there.
std::optional<SlitDisks> braided(const DottedDisk& rest, const DottedDisk& deformed, int search);

}  // namespace foldless
