// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over triangles by one thread.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/energy/element_sums.h"
#include "core/energy/objective.h"

namespace foldless {
namespace {

constexpr auto kOwnsAll = [](int) { return true; };

}  // namespace

void Objective::sum_elements(const ElementBatch& batch, EnergyTerms& sum) const {
  const ElementLoops& loops = element_loops(batch.settings.density->kind);
  std::array<ElementEnergy, kTrianglesAtATime> energies;
  for_few(0, triangles_.cols(), [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    if (std::isinf(sum.barrier)) return;
    loops.energies(batch, begin, end, {energies.data(), nullptr, nullptr});
    sum.add(sum_of_few(std::span(energies).first(static_cast<std::size_t>(end - begin))));
  });
}

void Objective::sum_elements(const ElementBatch& batch, EnergyGradient& sum) const {
  const ElementLoops& loops = element_loops(batch.settings.density->kind);
  ElementRoom room;
  for_few(0, triangles_.cols(), [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    loops.gradients(batch, begin, end, room.results());
    const FewElements few{room, triangles_, begin, end};
    sum.energy.add(few.energy());
    few.add_gradients(kOwnsAll, sum.gradient);
  });
}

void Objective::sum_elements(const ElementBatch& batch, const Constraints& constraints,
                             EnergyGradient& sum, SparseSymmetric& hessian) const {
  std::fill(hessian.value.begin(), hessian.value.end(), 0.0);
  const ElementLoops& loops = element_loops(batch.settings.density->kind);
  ElementRoom room;
  for_few(0, triangles_.cols(), [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    loops.hessians(batch, begin, end, room.results());
    const FewElements few{room, triangles_, begin, end};
    sum.energy.add(few.energy());
    few.add_gradients(kOwnsAll, sum.gradient);
    few.add_hessians(
        kOwnsAll, [&](int v) { return node_of(v, constraints); }, hessian);
  });
}

}  // namespace foldless
