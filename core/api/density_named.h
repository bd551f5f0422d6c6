// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core/energy/density.h"

namespace foldless {

/// A row of densities(). Throws Error when there is none of that name.
const Density& density_named(std::string_view name);

}  // namespace foldless
