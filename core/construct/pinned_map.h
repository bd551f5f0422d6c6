// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "core/construct/slits.h"
#include "core/mesh/mesh_pair.h"

namespace foldless {

/// Of classes of maps that pinned_map() tells apart.
inline constexpr int kClassesOfPinnedDisks = 6;
/// Without a braid: made the soonest.
inline constexpr int kClassOfShortestSlits = 2;

/// What is made of a map; nothing where rounding is in the way.
using UseOfMap = std::function<std::optional<MeshPair>(const MeshPair&)>;

/// What `use` makes of a map of one disk onto the other. Its first vertices are the corners of the
/// outline and the points inside. The disks are cut open to these points, along the curves of a
/// braid, see braided(), or, where that leaves too many, along the shortest slits, see slit_open(),
/// and the polygons that are left mapped by compatible_triangulation(). `choice`: of the class of
/// maps, from 0 to kClassesOfPinnedDisks − 1; one of which `use` makes nothing gives way to others.
/// Nothing where an outline bounds no disk, points are not inside, a disk lies over itself there,
/// or `use` makes nothing of any.
std::optional<MeshPair> pinned_map(const DottedDisk& rest, const DottedDisk& deformed, int choice,
                                   const UseOfMap& use);

}  // namespace foldless
