// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/rig/mirror_axis.h"

namespace foldless {

/// Ids of the handles that are the joints of a chain of bones, root first; two or more.
using Bones = std::vector<int>;

/// The axis that handles are mirrored in.
struct Mirror {
  MirrorAxis axis;
  bool is_on = true;  ///< off: it is only remembered

  bool operator==(const Mirror&) const = default;
};

/// What ties handles to each other while they are moved; the solver has no part in it.
struct Rig {
  std::vector<Bones> bones;      ///< no handle is in two of them
  std::optional<Mirror> mirror;  ///< none: the drawing was never mirrored

  bool operator==(const Rig&) const = default;
};

}  // namespace foldless
