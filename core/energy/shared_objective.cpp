// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over triangles by several threads: first every triangle's part, then for every vertex, or
// column of the Hessian, the parts of the triangles round it. The loops of objective.cpp add up the
// same numbers in the same order.
#include "core/energy/objective.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/energy/element_sums.h"
#include "core/threads/unfilled_vector.h"

namespace foldless {
namespace {

/// Vertices that a thread takes together: a few microseconds.
constexpr std::ptrdiff_t kVerticesTogether = 256;

template <class Visit>
void for_vertices(std::ptrdiff_t count, const Visit& visit) {
  each_in_ranges(count, kVerticesTogether, visit);
}

void clear_columns(SparseSymmetric& matrix, std::ptrdiff_t node) {
  const auto j = static_cast<std::size_t>(node);
  std::fill(matrix.value.begin() + matrix.first_column(j),
            matrix.value.begin() + matrix.first_column(j + 1), 0.0);
}

}  // namespace

void Objective::add_energies(ElementEnergy* energies, EnergyTerms& sum) const {
  static_assert(kTrianglesTogether % kTrianglesAtATime == 0);
  in_ranges(triangles_.cols(), kTrianglesTogether, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    for_few(begin, end, [&](std::ptrdiff_t first, std::ptrdiff_t last) {
      energies[first] = sum_of_few({energies + first, energies + last});
    });
  });
  for_few(0, triangles_.cols(),
          [&](std::ptrdiff_t first, std::ptrdiff_t) { sum.add(energies[first]); });
}

void Objective::sum_shared(const ElementBatch& batch, EnergyTerms& sum) const {
  ElementEnergy* const energies = energies_.of_size(rest_.size());
  const ElementLoops& loops = element_loops(batch.settings.density->kind);
  in_ranges(triangles_.cols(), kTrianglesTogether, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    loops.energies(batch, begin, end, {energies + begin, nullptr, nullptr});
  });
  add_energies(energies, sum);
}

void Objective::sum_shared(const ElementBatch& batch, EnergyGradient& sum) const {
  ElementEnergy* const energies = energies_.of_size(rest_.size());
  Matrix2<double>* const gradients = gradients_.of_size(rest_.size());
  const ElementLoops& loops = element_loops(batch.settings.density->kind);
  in_ranges(triangles_.cols(), kTrianglesTogether, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    loops.gradients(batch, begin, end, {energies + begin, gradients + begin, nullptr});
  });
  add_energies(energies, sum.energy);
  for_vertices(corners_.vertices(), [&](std::ptrdiff_t v) {
    for (const auto& [triangle, corner] : corners_.of(v))
      sum.gradient.segment<2>(2 * v) += gradient_of_corner(gradients[triangle], corner);
  });
}

void Objective::sum_shared(const ElementBatch& batch, const Constraints& constraints,
                           EnergyGradient& sum, SparseSymmetric& hessian) const {
  ElementEnergy* const energies = energies_.of_size(rest_.size());
  Matrix2<double>* const gradients = gradients_.of_size(rest_.size());
  BlocksOf<double>* const hessians = hessians_.of_size(rest_.size());
  const ElementLoops& loops = element_loops(batch.settings.density->kind);
  in_ranges(triangles_.cols(), kTrianglesTogether, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    loops.hessians(batch, begin, end, {energies + begin, gradients + begin, hessians + begin});
  });
  add_energies(energies, sum.energy);
  for_vertices(corners_.vertices(), [&](std::ptrdiff_t v) {
    clear_columns(hessian, v);
    for (const auto& [triangle, corner] : corners_.of(v)) {
      sum.gradient.segment<2>(2 * v) += gradient_of_corner(gradients[triangle], corner);
      add_columns(hessians[triangle], {triangle, corner}, constraints, hessian);
    }
  });
}

SparseSymmetric Objective::shared_pattern() const {
  std::vector<int> start(static_cast<std::size_t>(corners_.vertices()) + 1, 0);
  // Later neighbours; two triangles share most of them.
  UnfilledVector<int> near(2 * static_cast<std::size_t>(triangles_.size()));
  const auto near_of = [&](std::ptrdiff_t v) { return near.begin() + 2 * corners_.before(v); };
  for_vertices(corners_.vertices(), [&](std::ptrdiff_t v) {
    auto end = near_of(v);
    for (const auto& [triangle, corner] : corners_.of(v))
      for (const int other : {1, 2}) {
        const int neighbour = triangles_((corner + other) % 3, triangle);
        if (neighbour > v) *end++ = neighbour;
      }
    std::sort(near_of(v), end);
    start[static_cast<std::size_t>(v) + 1] =
        static_cast<int>(std::unique(near_of(v), end) - near_of(v));
  });
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<int> graph(static_cast<std::size_t>(start.back()));
  for_vertices(corners_.vertices(), [&](std::ptrdiff_t v) {
    const auto i = static_cast<std::size_t>(v);
    std::copy_n(near_of(v), start[i + 1] - start[i], graph.begin() + start[i]);
  });
  return sparse_symmetric(std::move(start), std::move(graph));
}

}  // namespace foldless
