// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/method/foldless/prescribed_regions.h"

namespace foldless {

/// A proof that no locally injective map brings the handles that are not soft to their targets,
/// whatever is flipped and whatever is split but the boundaries of the regions: one sentence that
/// names vertices. Nothing when none was found, which does not say that there is such a map.
///
/// Such a map of a region covers every point off the polygon P of its boundary as often as P winds
/// round it. So it is proved when
/// - neighbours along the boundary have one target, or P goes straight back at a corner, or
/// - the area of P is negative, or P winds negatively round a point beside a corner of it, or
/// - P does not turn as often as the region's Euler characteristic says (Gauss–Bonnet), or
/// - more handles inside have one target than P winds round some point beside it, or
/// - the region is a disk, and P bounds none: see bounds_disk().
///
/// Without handles inside this decides all disks with up to kMostCornersOfADisk corners. Exact for
/// the targets as they are given, bar the area, whose rounding is bounded.
/// O(boundary × (boundary + handles inside)), where points beyond 5e7 tests of an edge are left
/// out; for such disks O(boundary³).
std::optional<std::string> why_infeasible(const std::vector<PrescribedRegion>& regions,
                                          const Constraints& constraints);

}  // namespace foldless
