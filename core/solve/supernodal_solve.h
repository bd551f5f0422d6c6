// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cholmod.h>

#include <Eigen/Core>

namespace foldless {

/// Solves L Lᵀ x = b in place, x and b in the order of the factor. CHOLMOD's own calls the BLAS for
/// every supernode, most of whose time goes into the calls where supernodes are a few columns wide.
/// `work` is scratch space. Precondition: a numeric supernodal factor whose supernodes have an even
/// number of columns, as symbolic_factor() makes them.
void supernodal_solve(const cholmod_factor& factor, Eigen::VectorXd& x, Eigen::VectorXd& work);

}  // namespace foldless
