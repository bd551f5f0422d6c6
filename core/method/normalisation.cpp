// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/normalisation.h"

#include <cmath>

namespace foldless {

Normalisation normalisation_for(const Points& rest) {
  const Vec2 lowest = rest.rowwise().minCoeff();
  const Vec2 highest = rest.rowwise().maxCoeff();
  const double diagonal = (highest - lowest).norm();
  return {std::exp2(-std::round(std::log2(diagonal))), 0.5 * (lowest + highest)};
}

}  // namespace foldless
