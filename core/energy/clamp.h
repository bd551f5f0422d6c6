// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "core/mesh/triangle.h"

namespace foldless {

/// The Hessian (4×4 over the columns of J) of an energy that is isotropic up to a linear term,
/// without the part `clamping` of its negative curvature: 0 leaves it as it is, 1 gives the
/// positive semidefinite matrix nearest to it. In the frame of the singular vectors of J such a
/// Hessian falls into two 2×2 blocks, so no iteration is needed [SGK19].
Eigen::Matrix4d clamped_hessian(const Eigen::Matrix4d& hessian, const Mat2& J, double clamping = 1);

}  // namespace foldless
