// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over triangles by one thread, a few triangles at a time, so that what they give stays in the
// cache until it is added up.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/energy/objective.h"

namespace foldless {
namespace {

constexpr std::ptrdiff_t kTrianglesAtATime = 64;

/// What so many triangles give.
struct Room {
  std::array<ElementEnergy, kTrianglesAtATime> energies;
  std::array<Matrix2<double>, kTrianglesAtATime> gradients;
  std::array<BlocksOf<double>, kTrianglesAtATime> hessians;

  ElementResults results() { return {energies.data(), gradients.data(), hessians.data()}; }
};

/// visit(begin, end) for ranges that make up 0 … count.
template <class Visit>
void for_few(std::ptrdiff_t count, const Visit& visit) {
  for (std::ptrdiff_t begin = 0; begin < count; begin += kTrianglesAtATime)
    visit(begin, std::min(begin + kTrianglesAtATime, count));
}

/// visit(t, i) for every triangle t of begin ≤ t < end, which has place i.
template <class Visit>
void for_places(std::ptrdiff_t begin, std::ptrdiff_t end, const Visit& visit) {
  for (std::ptrdiff_t t = begin; t < end; ++t) visit(t, static_cast<std::size_t>(t - begin));
}

}  // namespace

void Objective::sum_elements(const ElementBatch& batch, EnergyTerms& sum) const {
  const ElementLoops& loops = element_loops(batch.settings.density->kind);
  std::array<ElementEnergy, kTrianglesAtATime> energies;
  for_few(triangles_.cols(), [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    if (std::isinf(sum.barrier)) return;
    loops.energies(batch, begin, end, {energies.data(), nullptr, nullptr});
    for_places(begin, end, [&](std::ptrdiff_t, std::size_t place) { sum.add(energies[place]); });
  });
}

void Objective::sum_elements(const ElementBatch& batch, EnergyGradient& sum) const {
  const ElementLoops& loops = element_loops(batch.settings.density->kind);
  Room room;
  for_few(triangles_.cols(), [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    loops.gradients(batch, begin, end, room.results());
    for_places(begin, end, [&](std::ptrdiff_t t, std::size_t place) {
      sum.energy.add(room.energies[place]);
      for (int corner = 0; corner < 3; ++corner)
        sum.gradient.segment<2>(2 * triangles_(corner, t)) +=
            gradient_of_corner(room.gradients[place], corner);
    });
  });
}

void Objective::sum_elements(const ElementBatch& batch, const Constraints& constraints,
                             EnergyGradient& sum, SparseSymmetric& hessian) const {
  std::fill(hessian.value.begin(), hessian.value.end(), 0.0);
  const ElementLoops& loops = element_loops(batch.settings.density->kind);
  Room room;
  for_few(triangles_.cols(), [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    loops.hessians(batch, begin, end, room.results());
    for_places(begin, end, [&](std::ptrdiff_t t, std::size_t place) {
      sum.energy.add(room.energies[place]);
      for (int corner = 0; corner < 3; ++corner) {
        const int v = triangles_(corner, t);
        sum.gradient.segment<2>(2 * v) += gradient_of_corner(room.gradients[place], corner);
        add_columns(room.hessians[place], {t, corner}, constraints, hessian);
      }
    });
  });
}

}  // namespace foldless
