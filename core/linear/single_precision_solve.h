// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/linear/symbolic_factor.h"

namespace foldless {

/// True where this processor solves in single precision faster than in double precision.
bool solves_in_single_precision();

/// The values that factorize() in multifrontal.h makes, in single precision, zero above the
/// diagonal. `single` has room for factor.values.
void to_single_precision(const SymbolicFactor& factor, const double* values, float* single);
/// The same of one panel, shared by the team of this thread where it is large.
void to_single_precision(const Supernode& s, const double* panel, float* single);
/// So many values behind those of the factor are read and not used: they are to be finite.
constexpr int kSingleOverrun = 8;

/// Solves L Lᵀ x = b in place as triangular_solve() does: x has room for factor.solve_size()
/// values, `work` for sweep_work_size(factor, kSingleOverrun). Precondition:
/// solves_in_single_precision().
void triangular_solve_single(const SymbolicFactor& factor, const float* single, float* x,
                             float* work);

}  // namespace foldless
