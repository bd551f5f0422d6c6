// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/element_lanes.h"

namespace foldless {

const ElementLoops& plain_element_loops(DensityKind kind) { return loops_of<2>("plain", kind); }

}  // namespace foldless
