// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace foldless {

/// The smallest of 1, 2, 5 times a power of ten that is not below `least` > 0.
double round_step(double least);

/// The multiples of `step` from `low` to `high`; none where doubles cannot tell them apart.
std::vector<double> multiples(double step, double low, double high);

}  // namespace foldless
