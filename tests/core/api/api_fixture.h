// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <foldless/session.h>

#include <string>
#include <vector>

#include "core/error.h"
#include "core/mesh/generate.h"

namespace foldless::test {

/// What a caller of the library has: a mesh, handles and where they go.
struct Task {
  PointMatrix rest;
  TriangleMatrix triangles;
  std::vector<int> handles;
  PointMatrix targets;
};

/// A square of n × n cells whose left half changes places with the right: what cannot be done
/// without flips and splits.
inline Task swapped_square(int n) {
  GridOptions options;
  options.columns = options.rows = n;
  const Shape shape = grid(options);
  Task task;
  task.rest = shape.rest.transpose();
  task.triangles = shape.triangles.transpose();
  const int row = n / 2 * (n + 1);
  task.handles = {row + n / 4, row + 3 * n / 4, 0, n};
  task.targets.resize(4, 2);
  task.targets << 0.8, 0.5, 0.2, 0.5, 0, 0, 1, 0;
  return task;
}

/// A square that is pulled at two corners.
inline Task pulled_square(int n) {
  Task task = swapped_square(n);
  task.handles = {0, (n + 1) * (n + 1) - 1};
  task.targets.resize(2, 2);
  task.targets << -0.2, 0.1, 1.3, 1.1;
  return task;
}

inline Session session_of(const Task& task, const SolveOptions& options = {}) {
  return {task.rest, task.triangles, task.handles, task.targets, options};
}

inline Result solved(const Task& task, const SolveOptions& options = {}) {
  return solve(task.rest, task.triangles, task.handles, task.targets, options);
}

/// The largest distance between rows.
inline double farthest(const PointMatrix& a, const PointMatrix& b) {
  return (a - b).rowwise().norm().maxCoeff();
}

/// What an Error of the call says; empty where it throws none.
template <typename Call>
std::string words_of_error(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace foldless::test
