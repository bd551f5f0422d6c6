// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "tests/core/run/scripted_method.h"

namespace foldless::test {

/// The problem scaled, then shifted.
inline Problem placed(Problem problem, double scale, const Vec2& shift) {
  const auto move = [&](const Points& points) -> Points {
    return (points * scale).colwise() + shift;
  };
  problem.mesh =
      MeshPair(problem.mesh.triangles(), move(problem.mesh.rest()), move(problem.mesh.deformed()));
  for (Handle& handle : problem.handles) handle.target = handle.target * scale + shift;
  return problem;
}

/// Steps to the end, or `limit` steps; the records.
inline std::vector<Iteration> finish(Run& run, int limit = 2000) {
  std::vector<Iteration> records;
  while (static_cast<int>(records.size()) < limit) {
    const std::optional<Iteration> record = run.step({});
    if (!record) break;
    records.push_back(*record);
  }
  return records;
}

}  // namespace foldless::test
