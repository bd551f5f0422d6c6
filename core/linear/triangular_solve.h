// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cholmod.h>

#include <Eigen/Core>

namespace foldless {

/// Solves L Lᵀ x = b in place, x and b in the order of the factor. CHOLMOD's own takes one and a
/// half times as long, going through L entry by entry, or three times, calling the BLAS for every
/// supernode, most of which are a few columns wide. `work` is scratch space. Precondition: a
/// numeric factor L Lᵀ in which columns 2k and 2k + 1 have the same rows below them, as
/// symbolic_factor() makes them.
void triangular_solve(const cholmod_factor& factor, Eigen::VectorXd& x, Eigen::VectorXd& work);

}  // namespace foldless
