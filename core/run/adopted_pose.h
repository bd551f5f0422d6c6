// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>

#include "core/snapshot.h"

namespace foldless {

/// A snapshot whose large parts are shared with another where they are equal.
std::shared_ptr<const Snapshot> adopted_pose(const std::shared_ptr<const Snapshot>& snapshot,
                                             const Snapshot& previous);

/// What a snapshot adds to the memory that the one before it takes. [bytes]
std::size_t added_bytes(const Snapshot& snapshot, const Snapshot* before);

}  // namespace foldless
