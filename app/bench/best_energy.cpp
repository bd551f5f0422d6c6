// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/best_energy.h"

#include <algorithm>
#include <limits>

namespace foldless {
namespace {

bool counts_for_best(const BenchRow& row) {
  return row.has_reached() && row.overlapping_boundary_vertices == 0;
}

}  // namespace

BestEnergies::BestEnergies(std::span<const BenchRow> rows) {
  for (const BenchRow& row : rows) {
    if (!counts_for_best(row)) continue;
    const auto [place, is_new] = best_.try_emplace(row.scene, row.distortion_energy);
    if (!is_new) place->second = std::min(place->second, row.distortion_energy);
  }
}

double BestEnergies::ratio(const BenchRow& row) const {
  if (!counts_for_best(row)) return std::numeric_limits<double>::quiet_NaN();
  const double best = best_.at(row.scene);
  return row.distortion_energy == best ? 1 : row.distortion_energy / best;
}

}  // namespace foldless
