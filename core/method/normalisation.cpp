// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/normalisation.h"

#include <cmath>
#include <cstddef>

#include "core/threads/team.h"

namespace foldless {
namespace {

/// change(points) of some columns at a time, which threads share: it is done after every step.
template <class Change>
Points changed(const Points& points, const Change& change) {
  constexpr std::ptrdiff_t kPointsTogether = 4096;
  Points all(2, points.cols());
  in_ranges(points.cols(), kPointsTogether, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    all.middleCols(begin, end - begin) = change(points.middleCols(begin, end - begin));
  });
  return all;
}

}  // namespace

Points Normalisation::to_unit(const Points& deformed) const {
  return changed(deformed,
                 [&](const auto& some) { return ((some.colwise() - offset) * scale).eval(); });
}

Points Normalisation::from_unit(const Points& deformed) const {
  return changed(deformed,
                 [&](const auto& some) { return ((some / scale).colwise() + offset).eval(); });
}

Normalisation normalisation_for(const Points& rest) {
  const Vec2 lowest = rest.rowwise().minCoeff();
  const Vec2 highest = rest.rowwise().maxCoeff();
  const double diagonal = (highest - lowest).norm();
  return {std::exp2(-std::round(std::log2(diagonal))), 0.5 * (lowest + highest)};
}

}  // namespace foldless
