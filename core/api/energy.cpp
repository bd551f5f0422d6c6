// SPDX-License-Identifier: GPL-3.0-or-later
#include <foldless/energy.h>

#include "core/api/arrays.h"
#include "core/api/density_named.h"
#include "core/energy/densities.h"

namespace foldless {

const Density& density_named(std::string_view name) {
  if (const Density* density = find_density(name)) return *density;
  std::string known;
  for (const Density& density : densities())
    known += (known.empty() ? "" : ", ") + std::string(density.name);
  throw Error("there is no energy '" + std::string(name) + "'; choose one of: " + known);
}

std::vector<EnergyWords> energies() {
  std::vector<EnergyWords> words;
  for (const Density& density : densities())
    words.push_back(
        {std::string(density.name), std::string(density.title), std::string(density.citation)});
  return words;
}

Eigen::VectorXd energy_densities(const PointsRef& rest, const TrianglesRef& triangles,
                                 const PointsRef& deformed, std::string_view energy) {
  const Density& density = density_named(energy);
  check_points(rest, "rest positions", rest.rows(), "vertices");
  check_points(deformed, "deformed positions", rest.rows(), "vertices");
  const Triangles checked = triangles_of(triangles, rest.rows());
  const Points before = points_of(rest), after = points_of(deformed);
  Eigen::VectorXd values(checked.cols());
  for (Eigen::Index t = 0; t < checked.cols(); ++t)
    values[t] = density.value(deformation_gradient(before, after, checked.col(t)));
  return values;
}

double distortion_energy(const PointsRef& rest, const TrianglesRef& triangles,
                         const PointsRef& deformed, std::string_view energy) {
  const Eigen::VectorXd values = energy_densities(rest, triangles, deformed, energy);
  const Points before = points_of(rest);
  double sum = 0;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    sum += values[t] * signed_area(before, triangles.row(t).transpose());
  return sum;
}

}  // namespace foldless
