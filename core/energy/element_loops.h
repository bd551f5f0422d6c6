// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "core/energy/corner_blocks.h"
#include "core/energy/element.h"

namespace foldless {

/// Triangles of a mesh as an energy sees them.
struct ElementBatch {
  const EnergySettings& settings;
  const Triangles& triangles;         ///< 3 × #F
  std::span<const RestElement> rest;  ///< #F
  const Points& u;                    ///< 2 × #V
  double clamping = 0;                ///< as in element_hessian()
};

/// What some triangles in a row give, one place a triangle.
struct ElementResults {
  ElementEnergy* energies;
  Matrix2<double>* gradients;  ///< by corners 1 and 2, one a column; null where not asked for
  BlocksOf<double>* hessians;  ///< likewise
};

/// Loops over triangles, several of which are done at once. They give the bits of element_energy(),
/// element_gradient() and element_hessian(), whose preconditions they have.
struct ElementLoops {
  const char* name;
  /// For triangles begin ≤ t < end.
  void (*energies)(const ElementBatch& batch, std::ptrdiff_t begin, std::ptrdiff_t end,
                   const ElementResults& results);
  void (*gradients)(const ElementBatch& batch, std::ptrdiff_t begin, std::ptrdiff_t end,
                    const ElementResults& results);
  void (*hessians)(const ElementBatch& batch, std::ptrdiff_t begin, std::ptrdiff_t end,
                   const ElementResults& results);
};

/// Two at once, as every processor of 64 bits can.
const ElementLoops& plain_element_loops(DensityKind kind);
/// Four at once; null where the program or the processor does not have AVX2.
const ElementLoops* avx2_element_loops(DensityKind kind);
/// Eight at once; null where the program or the processor does not have AVX-512, or is not faster.
const ElementLoops* avx512_element_loops(DensityKind kind);
/// The best that this processor has.
const ElementLoops& element_loops(DensityKind kind);

}  // namespace foldless
