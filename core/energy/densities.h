// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "core/energy/density.h"

namespace foldless {

/// Every distortion energy of the program; the authority for names and defaults.
std::span<const Density> densities();

/// The row of that name, or null. The row lives as long as the program.
const Density* find_density(std::string_view name);

}  // namespace foldless
