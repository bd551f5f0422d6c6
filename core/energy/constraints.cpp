// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/constraints.h"

#include <utility>

namespace foldless {

Constraints constraints_of(const std::vector<Handle>& handles) {
  const auto count = static_cast<Eigen::Index>(handles.size());
  Constraints constraints;
  constraints.targets.resize(2, count);
  constraints.weights.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Handle& handle = handles[static_cast<std::size_t>(i)];
    const bool soft = handle.kind == HandleKind::soft;
    constraints.vertices.push_back(handle.vertex);
    constraints.targets.col(i) = handle.target;
    constraints.weights[i] = soft ? handle.weight : 1;
    constraints.soft.push_back(soft);
  }
  return constraints;
}

std::vector<bool> have_hard_handles(const Constraints& constraints, int vertices) {
  std::vector<bool> have(static_cast<std::size_t>(vertices), false);
  for (std::size_t i = 0; i < constraints.vertices.size(); ++i)
    if (!constraints.soft[i]) have[static_cast<std::size_t>(constraints.vertices[i])] = true;
  return have;
}

double penalty(const Constraints& constraints, const Points& u) {
  double sum = 0;
  for (int i = 0; i < constraints.count(); ++i) {
    if (constraints.is_eliminated(i)) continue;
    const int v = constraints.vertices[static_cast<std::size_t>(i)];
    sum += constraints.weights[i] * (u.col(v) - constraints.targets.col(i)).squaredNorm();
  }
  return sum;
}

double handle_error_squared(const Constraints& constraints, const Points& u) {
  double sum = 0;
  for (int i = 0; i < constraints.count(); ++i) {
    const auto row = static_cast<std::size_t>(i);
    if (constraints.soft[row]) continue;
    sum += (u.col(constraints.vertices[row]) - constraints.targets.col(i)).squaredNorm();
  }
  return sum;
}

Points handle_positions(const Constraints& constraints, const Points& u) {
  return u(Eigen::all, constraints.vertices);
}

Constraints with_targets(Constraints constraints, Points targets) {
  constraints.targets = std::move(targets);
  return constraints;
}

Constraints held(Constraints constraints) {
  constraints.held = true;
  return constraints;
}

}  // namespace foldless
