// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over triangles by several threads: first every triangle's part, then for every vertex, or
// column of the Hessian, the parts of the triangles round it. The loops of objective.cpp add up the
// same numbers in the same order.
#include "core/energy/objective.h"

#include <algorithm>

namespace foldless {
namespace {

/// Vertices that a thread takes together: a few microseconds.
constexpr std::ptrdiff_t kVerticesTogether = 256;

template <class Visit>
void for_vertices(std::ptrdiff_t count, const Visit& visit) {
  in_ranges(count, kVerticesTogether, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    for (std::ptrdiff_t v = begin; v < end; ++v) visit(v);
  });
}

void clear_columns(SparseSymmetric& matrix, std::ptrdiff_t node) {
  const auto column = 2 * static_cast<std::size_t>(node);
  std::fill(matrix.value.begin() + matrix.column_start[column],
            matrix.value.begin() + matrix.column_start[column + 2], 0.0);
}

}  // namespace

void Objective::sum_shared(const Energy& energy, const Points& u, EnergyTerms& sum) const {
  ElementEnergy* const elements = energies_.of_size(rest_.size());
  for_triangles(triangles_.cols(), [&](Eigen::Index t) {
    energies_.set(elements + t, element_energy(energy.settings, reference(energy.settings, t),
                                               corners_of(u, triangles_.col(t))));
  });
  for (const ElementEnergy& element : std::span(elements, rest_.size())) sum.add(element);
}

void Objective::sum_shared(const Energy& energy, const Points& u, EnergyGradient& sum) const {
  ElementGradient* const elements = gradients_.of_size(rest_.size());
  ElementEnergy* const energies = energies_.of_size(rest_.size());
  for_triangles(triangles_.cols(), [&](Eigen::Index t) {
    const ElementGradient& element = gradients_.set(
        elements + t, element_gradient(energy.settings, reference(energy.settings, t),
                                       corners_of(u, triangles_.col(t))));
    energies_.set(energies + t, element.energy);
  });
  for (const ElementEnergy& element : std::span(energies, rest_.size())) sum.energy.add(element);
  for_vertices(corners_.vertices(), [&](std::ptrdiff_t v) {
    for (const auto& [triangle, corner] : corners_.of(v))
      sum.gradient.segment<2>(2 * v) += elements[triangle].gradient.segment<2>(2 * corner);
  });
}

void Objective::sum_shared(const SecondOrder& at, EnergyGradient& sum,
                           SparseSymmetric& hessian) const {
  ElementHessian* const elements = hessians_.of_size(rest_.size());
  ElementEnergy* const energies = energies_.of_size(rest_.size());
  for_triangles(triangles_.cols(), [&](Eigen::Index t) {
    const ElementHessian& element = hessians_.set(elements + t, second_order(at, t));
    energies_.set(energies + t, element.energy);
  });
  for (const ElementEnergy& element : std::span(energies, rest_.size())) sum.energy.add(element);
  for_vertices(corners_.vertices(), [&](std::ptrdiff_t v) {
    clear_columns(hessian, v);
    const int j = node_of(static_cast<int>(v), at.energy.constraints);
    for (const auto& [triangle, corner] : corners_.of(v)) {
      const ElementHessian& element = elements[triangle];
      sum.gradient.segment<2>(2 * v) += element.gradient.segment<2>(2 * corner);
      if (j < 0) continue;
      for (int other = 0; other < 3; ++other) {
        const int i = node_of(triangles_(other, triangle), at.energy.constraints);
        if (i >= j) add_block(hessian, i, j, element.hessian.block<2, 2>(2 * other, 2 * corner));
      }
    }
  });
}

}  // namespace foldless
