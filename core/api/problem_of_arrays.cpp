// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/api/problem_of_arrays.h"

#include <cmath>
#include <string>
#include <utility>

#include "core/api/arrays.h"
#include "core/api/density_named.h"
#include "core/error.h"
#include "core/files/validate.h"

namespace foldless {
namespace {

void check_positive(const std::optional<double>& number, const char* what) {
  if (!number || (*number > 0 && std::isfinite(*number))) return;
  throw Error(std::string(what) + " is " + std::to_string(*number) +
              "; give a number above 0, or none");
}

MeshPair mesh_of_arrays(const PointsRef& rest, const TrianglesRef& triangles) {
  check_points(rest, "rest positions", rest.rows(), "vertices");
  const Triangles checked = triangles_of(triangles, rest.rows());
  const Points points = points_of(rest);
  MeshSource source;
  source.name = "mesh";
  check_connectivity(checked, static_cast<int>(points.cols()), source);
  check_positions(checked, points, source);
  return {checked, points};
}

std::vector<Handle> handles_of_arrays(const MeshPair& mesh, const std::vector<int>& vertices,
                                      const PointsRef& targets) {
  check_points(targets, "targets", static_cast<Eigen::Index>(vertices.size()), "handles");
  std::vector<bool> is_named(static_cast<std::size_t>(mesh.vertex_count()), false);
  std::vector<Handle> handles;
  for (const int v : vertices) {
    const std::string name = "handle " + std::to_string(handles.size());
    if (v < 0 || v >= mesh.vertex_count())
      throw Error(name + " is at the vertex " + std::to_string(v) + ", but the vertices are 0 to " +
                  std::to_string(mesh.vertex_count() - 1));
    if (mesh.is_isolated(v))
      throw Error(name + " is at the vertex " + std::to_string(v) +
                  ", which no triangle uses; choose another");
    if (is_named[static_cast<std::size_t>(v)])
      throw Error(name + " is at the vertex " + std::to_string(v) +
                  ", where an earlier one is already; leave one out");
    is_named[static_cast<std::size_t>(v)] = true;
    Handle handle;
    handle.id = static_cast<int>(handles.size());
    handle.vertex = v;
    handle.target = targets.row(handle.id).transpose();
    handles.push_back(handle);
  }
  return handles;
}

}  // namespace

// NOLINTNEXTLINE(readability-function-size): what solve() takes, in its order
Problem problem_of_arrays(const PointsRef& rest, const TrianglesRef& triangles,
                          const std::vector<int>& handles, const PointsRef& targets,
                          const SolveOptions& options) {
  check_positive(options.time_limit, "the time limit");
  check_positive(options.beta, "beta");
  if (options.threads < 1) throw Error("the number of threads has to be 1 or more");
  Problem problem;
  problem.energy = &density_named(options.energy);
  problem.mesh = mesh_of_arrays(rest, triangles);
  problem.handles = handles_of_arrays(problem.mesh, handles, targets);
  problem.parameters.beta = options.beta;
  return problem;
}

MethodStarter starter_for(const SolveOptions& options) {
  if (!options.fixed_triangulation) return start_method;
  return [](const Problem& problem) {
    Problem fixed = problem;
    fixed.parameters.method = "paper-noflip";
    return start_method(fixed);
  };
}

}  // namespace foldless
