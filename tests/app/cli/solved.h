// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "core/files/mesh_io.h"
#include "core/mesh/injective.h"
#include "tests/core/run/scripted_method.h"

namespace foldless::test {

/// A scene of a grid that flips edges on its way and is satisfied.
inline Problem flipping_problem() {
  Problem problem = grid_problem(6, Vec2(2.5, 2.2));
  problem.energy = find_density("lscm");
  return problem;
}

inline void expect_valid_results(const std::string& folder) {
  const LoadedMesh rest = read_mesh(folder + "/rest.obj");
  const LoadedMesh deformed = read_mesh(folder + "/deformed.obj");
  ASSERT_EQ(rest.triangles, deformed.triangles);
  EXPECT_TRUE(is_injective(rest.triangles, rest.points, deformed.points));
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace foldless::test
