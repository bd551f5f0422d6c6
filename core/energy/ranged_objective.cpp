// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over triangles by several threads, each of which adds up what belongs to the vertices of a
// range, in the order in which one thread alone does: a triangle between ranges is evaluated in
// each, which costs less than keeping what all triangles give.
#include <algorithm>
#include <numeric>
#include <utility>

#include "core/energy/element_sums.h"
#include "core/energy/objective.h"
#include "core/threads/team.h"

namespace foldless {
namespace {

/// Calls visit(begin, end) for a few of the range's triangles after the other.
template <class Visit>
void for_few_of(const VertexRange& range, const Visit& visit) {
  for (const auto& [first, last] : range.runs) for_few(first, last, visit);
}

/// Energies of the triangles whose first corner the range owns, to their places.
void keep_energies(const FewElements& few, const VertexRange& range, ElementEnergy* energies) {
  for (std::ptrdiff_t t = few.begin; t < few.end; ++t)
    if (range.owns(few.triangles(0, t)))
      energies[t] = few.room.energies[static_cast<std::size_t>(t - few.begin)];
}

void clear_columns(SparseSymmetric& matrix, const VertexRange& range) {
  std::fill(matrix.value.begin() + matrix.first_column(static_cast<std::size_t>(range.begin)),
            matrix.value.begin() + matrix.first_column(static_cast<std::size_t>(range.end)), 0.0);
}

/// visit(v, w) for every side of the range's triangles whose first vertex v it owns, v < w.
template <class Visit>
void for_sides(const VertexRange& range, const Triangles& triangles, const Visit& visit) {
  for (const auto& [begin, end] : range.runs)
    for (int t = begin; t < end; ++t)
      for (int corner = 0; corner < 3; ++corner) {
        const auto [v, w] = std::minmax(triangles(corner, t), triangles((corner + 1) % 3, t));
        if (range.owns(v)) visit(v, w);
      }
}

/// The later neighbours of the range's vertices, one vertex after the other, sorted; how many they
/// are to `counts`, the place after the vertex.
std::vector<int> later_neighbours_of(const VertexRange& range, const Triangles& triangles,
                                     std::vector<int>& counts) {
  std::vector<int> next(static_cast<std::size_t>(range.end - range.begin) + 1, 0);
  const auto place = [&](int v) { return static_cast<std::size_t>(v - range.begin); };
  for_sides(range, triangles, [&](int v, int) { ++next[place(v) + 1]; });
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<int> later(static_cast<std::size_t>(next.back()));
  for_sides(range, triangles,
            [&](int v, int w) { later[static_cast<std::size_t>(next[place(v)]++)] = w; });
  auto first = later.begin(), kept = first;
  for (int v = range.begin; v < range.end; ++v) {  // a vertex's next is now its end
    const auto last = later.begin() + next[place(v)];
    std::sort(first, last);
    const auto end = std::unique_copy(first, last, kept);
    counts[static_cast<std::size_t>(v) + 1] = static_cast<int>(end - kept);
    kept = end;
    first = last;
  }
  later.erase(kept, later.end());
  return later;
}

}  // namespace

void Objective::sum_ranges(const ElementBatch& batch, EnergyGradient& sum) const {
  ElementEnergy* const energies = energies_.of_size(rest_.size());
  const ElementLoops& loops = element_loops(batch.settings.density->kind);
  in_parallel(static_cast<int>(vertex_ranges_.size()), [&](int i) {
    const VertexRange& range = vertex_ranges_[static_cast<std::size_t>(i)];
    const auto owns = [&](int v) { return range.owns(v); };
    ElementRoom room;
    for_few_of(range, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
      loops.gradients(batch, begin, end, room.results());
      const FewElements few{room, triangles_, begin, end};
      keep_energies(few, range, energies);
      few.add_gradients(owns, sum.gradient);
    });
  });
  add_energies(energies, sum.energy);
}

void Objective::sum_ranges(const ElementBatch& batch, const Constraints& constraints,
                           EnergyGradient& sum, SparseSymmetric& hessian) const {
  ElementEnergy* const energies = energies_.of_size(rest_.size());
  const ElementLoops& loops = element_loops(batch.settings.density->kind);
  in_parallel(static_cast<int>(vertex_ranges_.size()), [&](int i) {
    const VertexRange& range = vertex_ranges_[static_cast<std::size_t>(i)];
    const auto owns = [&](int v) { return range.owns(v); };
    clear_columns(hessian, range);
    ElementRoom room;
    for_few_of(range, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
      loops.hessians(batch, begin, end, room.results());
      const FewElements few{room, triangles_, begin, end};
      keep_energies(few, range, energies);
      few.add_gradients(owns, sum.gradient);
      few.add_hessians(
          owns, [&](int v) { return node_of(v, constraints); }, hessian);
    });
  });
  add_energies(energies, sum.energy);
}

SparseSymmetric Objective::ranged_pattern() const {
  std::vector<int> start(has_hard_handle_.size() + 1, 0);
  std::vector<std::vector<int>> later(vertex_ranges_.size());
  const auto count = static_cast<int>(vertex_ranges_.size());
  in_parallel(count, [&](int i) {
    const auto place = static_cast<std::size_t>(i);
    later[place] = later_neighbours_of(vertex_ranges_[place], triangles_, start);
  });
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<int> graph(static_cast<std::size_t>(start.back()));
  in_parallel(count, [&](int i) {
    const auto place = static_cast<std::size_t>(i);
    const auto begin = static_cast<std::size_t>(vertex_ranges_[place].begin);
    std::ranges::copy(later[place], graph.begin() + start[begin]);
  });
  return sparse_symmetric(std::move(start), std::move(graph));
}

}  // namespace foldless
