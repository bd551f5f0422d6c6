// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <foldless/error.h>
#include <foldless/mesh.h>

#include <string>
#include <string_view>
#include <vector>

namespace foldless {

/// A distortion energy that solve() can minimise.
struct EnergyWords {
  std::string name;      ///< for SolveOptions::energy
  std::string title;     ///< in words
  std::string citation;  ///< key of the bibliography
};

/// All of them.
std::vector<EnergyWords> energies();

/// ψ(J) of every triangle, #F, J the deformation gradient that takes it from `rest` to `deformed`.
/// [dimensionless] Throws Error on a name that energies() does not have, or arrays that do not go
/// together.
Eigen::VectorXd energy_densities(const PointsRef& rest, const TrianglesRef& triangles,
                                 const PointsRef& deformed, std::string_view energy);

/// Σ A ψ(J) over the triangles, A the area at rest. [length²] Throws as energy_densities().
double distortion_energy(const PointsRef& rest, const TrianglesRef& triangles,
                         const PointsRef& deformed, std::string_view energy);

}  // namespace foldless
