// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "core/linear/symbolic_factor.h"

namespace foldless {

/// Solves L Lᵀ x = b in place, x and b in the order of elimination, with the values that
/// factorize() in multifrontal.h makes. x has factor.solve_size() values, the first of which are of
/// interest. `work` is scratch space. The team of this thread does it, with the same bits however
/// many they are.
void triangular_solve(const SymbolicFactor& factor, const double* values, Eigen::VectorXd& x,
                      Eigen::VectorXd& work);

}  // namespace foldless
