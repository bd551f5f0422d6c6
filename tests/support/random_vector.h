// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/triangle.h"

namespace foldless::test {

/// Two numbers of a distribution, x first: as arguments of one call they would come in the order
/// that the compiler likes best, and a seed would stand for another scene with each.
template <typename Distribution, typename Generator>
Vec2 random_vector(Distribution& distribution, Generator& random) {
  const double x = distribution(random);
  const double y = distribution(random);
  return {x, y};
}

}  // namespace foldless::test
