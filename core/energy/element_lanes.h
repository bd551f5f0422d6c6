// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "core/energy/density_kinds.h"
#include "core/energy/element_formulas.h"
#include "core/energy/element_loops.h"

// Before it is included FOLDLESS_LOOP says for which processors its loops are compiled, where that
// is not for all. Everything in here is the including file's own: two of them do not share it.
#ifndef FOLDLESS_LOOP
#define FOLDLESS_LOOP
#endif

namespace foldless {
namespace {

template <int Count>
FOLDLESS_INLINED void set_lane(Matrix2<Lanes<Count>>& m, int lane, const Matrix2<double>& of) {
  m.a.numbers[lane] = of.a;
  m.b.numbers[lane] = of.b;
  m.c.numbers[lane] = of.c;
  m.d.numbers[lane] = of.d;
}

template <int Count>
FOLDLESS_INLINED Matrix2<double> lane_of(const Matrix2<Lanes<Count>>& m, int lane) {
  return {m.a.numbers[lane], m.b.numbers[lane], m.c.numbers[lane], m.d.numbers[lane]};
}

/// Triangles from `first` on; beyond the last one it once more.
template <int Count>
FOLDLESS_INLINED ElementOf<Lanes<Count>> elements_from(const ElementBatch& batch,
                                                       std::ptrdiff_t first, std::ptrdiff_t last) {
  ElementOf<Lanes<Count>> elements;
  for (int lane = 0; lane < Count; ++lane) {
    const std::ptrdiff_t t = std::min(first + lane, last);
    const RestElement* rest = &batch.rest[static_cast<std::size_t>(t)];
    RestElement reference;
    if (batch.settings.reference != Reference::rest) {
      reference = reference_element(batch.settings, *rest);
      rest = &reference;
    }
    elements.area.numbers[lane] = rest->area;
    elements.stiffness.numbers[lane] = rest->stiffness;
    const double* g = rest->gradients.data() + 2;
    set_lane(elements.gradients, lane, {g[0], g[1], g[2], g[3]});
    const int* corners = batch.triangles.data() + 3 * t;
    const double* u = batch.u.data();
    const double *x0 = u + 2 * static_cast<std::ptrdiff_t>(corners[0]),
                 *x1 = u + 2 * static_cast<std::ptrdiff_t>(corners[1]),
                 *x2 = u + 2 * static_cast<std::ptrdiff_t>(corners[2]);
    set_lane(elements.edges, lane, {x1[0] - x0[0], x1[1] - x0[1], x2[0] - x0[0], x2[1] - x0[1]});
  }
  return elements;
}

template <int Count>
FOLDLESS_INLINED void store(const EnergyOf<Lanes<Count>>& energy, int count, ElementEnergy* to) {
  for (int lane = 0; lane < count; ++lane)
    to[lane] = {energy.distortion.numbers[lane], energy.barrier.numbers[lane]};
}

template <class Kind, int Count>
FOLDLESS_LOOP void loop_of_energies(const ElementBatch& batch, std::ptrdiff_t begin,
                                    std::ptrdiff_t end, const ElementResults& results) {
  for (std::ptrdiff_t t = begin; t < end; t += Count)
    store(energy_of<Kind>(batch.settings, elements_from<Count>(batch, t, end - 1)),
          static_cast<int>(std::min<std::ptrdiff_t>(Count, end - t)),
          results.energies + (t - begin));
}

template <class Kind, int Count>
FOLDLESS_LOOP void loop_of_gradients(const ElementBatch& batch, std::ptrdiff_t begin,
                                     std::ptrdiff_t end, const ElementResults& results) {
  for (std::ptrdiff_t t = begin; t < end; t += Count) {
    const ElementOf<Lanes<Count>> elements = elements_from<Count>(batch, t, end - 1);
    const FirstOrder<Lanes<Count>> first = first_order_of<Kind>(batch.settings, elements);
    const int count = static_cast<int>(std::min<std::ptrdiff_t>(Count, end - t));
    store(first.energy, count, results.energies + (t - begin));
    for (int lane = 0; lane < count; ++lane)
      results.gradients[t - begin + lane] = lane_of(first.gradient, lane);
  }
}

template <class Kind, int Count>
FOLDLESS_LOOP void loop_of_hessians(const ElementBatch& batch, std::ptrdiff_t begin,
                                    std::ptrdiff_t end, const ElementResults& results) {
  for (std::ptrdiff_t t = begin; t < end; t += Count) {
    const ElementOf<Lanes<Count>> elements = elements_from<Count>(batch, t, end - 1);
    const FirstOrder<Lanes<Count>> first = first_order_of<Kind>(batch.settings, elements);
    const auto blocks = hessian_by_corners(first, elements.gradients, batch.clamping);
    const int count = static_cast<int>(std::min<std::ptrdiff_t>(Count, end - t));
    store(first.energy, count, results.energies + (t - begin));
    for (int lane = 0; lane < count; ++lane) {
      results.gradients[t - begin + lane] = lane_of(first.gradient, lane);
      BlocksOf<double>& to = results.hessians[t - begin + lane];
      to.of_11 = lane_of(blocks.of_11, lane);
      to.of_12 = lane_of(blocks.of_12, lane);
      to.of_22 = lane_of(blocks.of_22, lane);
    }
  }
}

template <int Count>
const ElementLoops& loops_of(const char* name, DensityKind kind) {
  return with_density(kind, [&](auto density) -> const ElementLoops& {
    using Kind = decltype(density);
    static const ElementLoops loops = {name, loop_of_energies<Kind, Count>,
                                       loop_of_gradients<Kind, Count>,
                                       loop_of_hessians<Kind, Count>};
    return loops;
  });
}

}  // namespace
}  // namespace foldless
