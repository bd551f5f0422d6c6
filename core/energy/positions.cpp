// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/positions.h"

namespace foldless {

Positions positions_of(const std::vector<Handle>& handles) {
  const auto count = static_cast<Eigen::Index>(handles.size());
  Positions positions;
  positions.targets.resize(2, count);
  positions.weights.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Handle& handle = handles[static_cast<std::size_t>(i)];
    const bool soft = handle.kind == HandleKind::soft;
    positions.vertices.push_back(handle.vertex);
    positions.targets.col(i) = handle.target;
    positions.weights[i] = soft ? handle.weight : 1;
    positions.soft.push_back(soft);
  }
  return positions;
}

double penalty(const Positions& positions, const Points& u) {
  double sum = 0;
  for (int i = 0; i < positions.count(); ++i) {
    if (positions.is_eliminated(i)) continue;
    const int v = positions.vertices[static_cast<std::size_t>(i)];
    sum += positions.weights[i] * (u.col(v) - positions.targets.col(i)).squaredNorm();
  }
  return sum;
}

double handle_error_squared(const Positions& positions, const Points& u) {
  double sum = 0;
  for (int i = 0; i < positions.count(); ++i) {
    const auto row = static_cast<std::size_t>(i);
    if (positions.soft[row]) continue;
    sum += (u.col(positions.vertices[row]) - positions.targets.col(i)).squaredNorm();
  }
  return sum;
}

Positions held_where_they_are(const Positions& positions, const Points& u) {
  Positions held = positions;
  for (int i = 0; i < held.count(); ++i)
    held.targets.col(i) = u.col(held.vertices[static_cast<std::size_t>(i)]);
  return held;
}

}  // namespace foldless
