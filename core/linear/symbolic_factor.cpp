// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/symbolic_factor.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <memory>
#include <new>
#include <span>

#include "core/error.h"

namespace foldless {
namespace {

/// Columns of supernodes that may be merged although that stores zeros: CHOLMOD's own limits are
/// twice these, for columns of the matrix.
constexpr std::size_t kRelaxed[] = {2, 8, 24};

struct FreeFactor {
  cholmod_common* common;
  void operator()(cholmod_factor* factor) const { cholmod_free_factor(&factor, common); }
};
using FactorPointer = std::unique_ptr<cholmod_factor, FreeFactor>;

std::span<int> ints(void* array, std::size_t count) { return {static_cast<int*>(array), count}; }

void* allocate(std::size_t count, cholmod_common& common) {
  void* array = cholmod_malloc(count, sizeof(int), &common);
  if (!array) throw std::bad_alloc();
  return array;
}

void expand_columns(const cholmod_factor& graph, cholmod_factor& factor) {
  const std::span<int> order = ints(graph.Perm, graph.n), count = ints(graph.ColCount, graph.n);
  const std::span<int> expanded_order = ints(factor.Perm, factor.n);
  const std::span<int> expanded_count = ints(factor.ColCount, factor.n);
  for (std::size_t k = 0; k < graph.n; ++k) {
    expanded_order[2 * k] = 2 * order[k];
    expanded_order[2 * k + 1] = 2 * order[k] + 1;
    expanded_count[2 * k] = 2 * count[k];
    expanded_count[2 * k + 1] = 2 * count[k] - 1;
  }
}

void expand_supernodes(const cholmod_factor& graph, cholmod_factor& factor,
                       cholmod_common& common) {
  const std::size_t ends = graph.nsuper + 1;
  // The library counts with int, as the places in `px` do.
  if (graph.xsize > static_cast<std::size_t>(std::numeric_limits<int>::max()) / 4)
    throw Error("the mesh has too many triangles for the solver; use a coarser one");
  factor.is_super = factor.is_ll = 1;
  factor.nsuper = graph.nsuper;
  factor.super = allocate(ends, common);
  factor.pi = allocate(ends, common);
  factor.px = allocate(ends, common);
  factor.ssize = 2 * graph.ssize;
  factor.s = allocate(factor.ssize, common);
  factor.xsize = 4 * graph.xsize;
  factor.maxcsize = 4 * graph.maxcsize;
  factor.maxesize = 2 * graph.maxesize;
  for (std::size_t i = 0; i < ends; ++i) {
    ints(factor.super, ends)[i] = 2 * ints(graph.super, ends)[i];
    ints(factor.pi, ends)[i] = 2 * ints(graph.pi, ends)[i];
    ints(factor.px, ends)[i] = 4 * ints(graph.px, ends)[i];
  }
  const std::span<int> rows = ints(graph.s, graph.ssize);
  const std::span<int> expanded_rows = ints(factor.s, factor.ssize);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    expanded_rows[2 * i] = 2 * rows[i];
    expanded_rows[2 * i + 1] = 2 * rows[i] + 1;
  }
}

}  // namespace

cholmod_sparse view_of_graph(const SparseSymmetric& matrix) {
  cholmod_sparse graph{};
  graph.nrow = graph.ncol = static_cast<std::size_t>(matrix.nodes);
  graph.nzmax = matrix.graph.size();
  // CHOLMOD takes pointers to non-const and does not write through them.
  graph.p = const_cast<int*>(matrix.graph_start.data());
  graph.i = const_cast<int*>(matrix.graph.data());
  graph.stype = -1;
  graph.itype = CHOLMOD_INT;
  graph.xtype = CHOLMOD_PATTERN;
  graph.dtype = CHOLMOD_DOUBLE;
  graph.sorted = 1;
  graph.packed = 1;
  return graph;
}

cholmod_factor* symbolic_factor(const SparseSymmetric& matrix, std::vector<int>& ordering,
                                cholmod_common& common) {
  std::copy(std::begin(kRelaxed), std::end(kRelaxed), common.nrelax);
  cholmod_sparse pattern = view_of_graph(matrix);
  const FactorPointer graph(cholmod_analyze_p(&pattern, ordering.data(), nullptr, 0, &common),
                            {&common});
  if (!graph) throw std::bad_alloc();
  FactorPointer factor(cholmod_allocate_factor(2 * graph->n, &common), {&common});
  if (!factor) throw std::bad_alloc();
  expand_columns(*graph, *factor);
  if (graph->is_super) expand_supernodes(*graph, *factor, common);
  factor->ordering = CHOLMOD_NATURAL;  // the matrix comes in the order of the factor
  return factor.release();
}

}  // namespace foldless
