// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy/density.h"
#include "core/scene/json_node.h"
#include "core/scene/parameters.h"

namespace foldless {

/// Every parameter but the method by its name, as a scene file has them; β of the method or the
/// energy where none is given.
JsonNode parameters_node(const Parameters& parameters, const Density& energy);

}  // namespace foldless
