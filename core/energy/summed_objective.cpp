// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over triangles by one thread, a few triangles at a time, so that what they give stays in the
// cache until it is added up.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/energy/node_blocks.h"
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

/// All blocks of a triangle whose corners are those nodes, −1 for none.
void add_triangle(const BlocksOf<double>& blocks, const std::array<int, 3>& nodes,
                  SparseSymmetric& hessian) {
  for (int column = 0; column < 3; ++column) {
    const int j = nodes[static_cast<std::size_t>(column)];
    if (j < 0) continue;
    add_diagonal_block(block_of_corners(blocks, column, column), j, hessian);
    for (int row = 0; row < column; ++row) {
      const int i = nodes[static_cast<std::size_t>(row)];
      if (i < 0) continue;
      if (i > j)
        add_later_block(block_of_corners(blocks, row, column), i, j, hessian);
      else
        add_later_block(block_of_corners(blocks, column, row), j, i, hessian);
    }
  }
}

}  // namespace

void Objective::sum_elements(const ElementBatch& batch, EnergyTerms& sum) const {
  const ElementLoops& loops = element_loops(batch.settings.density->kind);
  std::array<ElementEnergy, kTrianglesAtATime> energies;
  for_few(triangles_.cols(), [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    if (std::isinf(sum.barrier)) return;
    loops.energies(batch, begin, end, {energies.data(), nullptr, nullptr});
    sum.add(std::span(energies).first(static_cast<std::size_t>(end - begin)));
  });
}

void Objective::sum_elements(const ElementBatch& batch, EnergyGradient& sum) const {
  const ElementLoops& loops = element_loops(batch.settings.density->kind);
  Room room;
  for_few(triangles_.cols(), [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    loops.gradients(batch, begin, end, room.results());
    sum.energy.add(std::span(room.energies).first(static_cast<std::size_t>(end - begin)));
    for_places(begin, end, [&](std::ptrdiff_t t, std::size_t place) {
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
    sum.energy.add(std::span(room.energies).first(static_cast<std::size_t>(end - begin)));
    for_places(begin, end, [&](std::ptrdiff_t t, std::size_t place) {
      std::array<int, 3> nodes;
      for (int corner = 0; corner < 3; ++corner) {
        const int v = triangles_(corner, t);
        sum.gradient.segment<2>(2 * v) += gradient_of_corner(room.gradients[place], corner);
        nodes[static_cast<std::size_t>(corner)] = node_of(v, constraints);
      }
      add_triangle(room.hessians[place], nodes, hessian);
    });
  });
}

}  // namespace foldless
