// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <string>
#include <utility>

#include "app/cli/calls.h"
#include "app/cli/check_line.h"
#include "app/cli/command_line.h"
#include "app/cli/problem.h"
#include "app/cli/solved_folder.h"
#include "core/energy/constraints.h"
#include "core/error.h"
#include "core/mesh/injective.h"
#include "core/mesh/orientation.h"
#include "core/method/satisfied.h"
#include "core/run/active_part.h"
#include "core/run/followers.h"

namespace foldless {
namespace {

/// Distortion over the triangles that are counter-clockwise in both meshes.
struct Distortion {
  double min_area_ratio = std::numeric_limits<double>::infinity();
  double max_area_ratio = 0;
  double conformal_max = 0;
  double conformal_sum = 0;
  int triangles = 0;
};

Distortion distortion_of(const Triangles& triangles, const Points& rest, const Points& deformed) {
  Distortion d;
  for (const auto& t : triangles.colwise()) {
    const double area = signed_area(rest, t);
    const double ratio = signed_area(deformed, t) / area;
    if (area > 0) d.min_area_ratio = std::min(d.min_area_ratio, ratio);
    if (!(area > 0 && ratio > 0)) continue;
    const double sigma1 = signed_singular_values(deformation_gradient(rest, deformed, t))[0];
    const double conformal = sigma1 * sigma1 / ratio;
    d.max_area_ratio = std::max(d.max_area_ratio, ratio);
    d.conformal_max = std::max(d.conformal_max, conformal);
    d.conformal_sum += conformal;
    ++d.triangles;
  }
  return d;
}

bool add_injectivity(const MeshFiles& files, CheckLine& line) {
  const Triangles& triangles = files.rest.triangles;
  const InjectivityReport rest = check_injectivity(triangles, files.rest.points);
  const InjectivityReport deformed = check_injectivity(triangles, files.deformed.points);
  line.add("vertices", static_cast<double>(files.rest.points.cols()));
  line.add("faces", static_cast<double>(triangles.cols()));
  line.add("flipped", deformed.inverted + 0.0);
  line.add("degenerate", deformed.degenerate + 0.0);
  line.add("branch_vertices", deformed.branch_vertices + 0.0);
  line.add("overlapping_boundary_vertices", deformed.overlapping_boundary_vertices.size() + 0.0);
  line.add("rest_nonpositive", rest.inverted + rest.degenerate + 0.0);
  line.add("rest_branch_vertices", rest.branch_vertices + 0.0);
  line.add("rest_overlapping_boundary_vertices", rest.overlapping_boundary_vertices.size() + 0.0);
  const auto name_problems = [&](const InjectivityReport& report, const std::string& mesh) {
    if (report.inverted + report.degenerate > 0)
      line.add_problem(std::to_string(report.inverted) + " inverted and " +
                       std::to_string(report.degenerate) + " degenerate triangles in the " + mesh +
                       " mesh");
    if (report.branch_vertices > 0)
      line.add_problem(std::to_string(report.branch_vertices) +
                       " interior vertices are covered more than once in the " + mesh +
                       " mesh, first vertex " + std::to_string(*report.first_branch_vertex));
    if (!report.overlapping_boundary_vertices.empty())
      line.add_problem(std::to_string(report.overlapping_boundary_vertices.size()) +
                       " boundary vertices overlap themselves in the " + mesh +
                       " mesh, first vertex " +
                       std::to_string(report.overlapping_boundary_vertices.front()));
  };
  name_problems(rest, "rest");
  name_problems(deformed, "deformed");
  const bool is_injective = rest.is_injective() && deformed.is_injective();
  line.add("locally_injective", is_injective);
  return is_injective;
}

void add_distortion(const MeshFiles& files, CheckLine& line) {
  const Distortion d =
      distortion_of(files.rest.triangles, files.rest.points, files.deformed.points);
  line.add("min_area_ratio", d.min_area_ratio);
  line.add("max_area_ratio", d.max_area_ratio);
  line.add("conformal_max", d.conformal_max);
  line.add("conformal_mean", d.conformal_sum / d.triangles);
}

void add_handles(const Scene& scene, const MeshFiles& files, CheckLine& line) {
  const Points& deformed = files.deformed.points;
  // A solver may have removed vertices of splits that the scene's state has, but none of a handle.
  Eigen::Index expected = scene.rest.cols();
  for (const Handle& handle : scene.handles)
    expected = std::max<Eigen::Index>(expected, handle.vertex + 1);
  if (deformed.cols() < expected)
    throw Error("the meshes have " + std::to_string(deformed.cols()) +
                " vertices, but the scene needs " + std::to_string(expected));
  const Followers followers(scene.triangles, files.rest.points, scene.handles);
  const std::vector<Handle> held = followers.with_followers(scene.handles);
  const Constraints positions = constraints_of(held);
  const double error = handle_error_squared(positions, deformed);
  double largest = 0;
  for (const Handle& handle : held)
    if (handle.kind != HandleKind::soft)
      largest = std::max(largest, (deformed.col(handle.vertex) - handle.target).norm());
  const double diagonal = active_diagonal(files.rest.triangles, files.rest.points, scene.handles);
  const bool is_satisfied = error <= kSatisfied * diagonal * diagonal;
  const bool is_rest_kept = files.rest.points.leftCols(scene.rest.cols()) == scene.rest;
  line.add("original_vertices", static_cast<double>(scene.rest.cols()));
  line.add("original_vertices_kept", is_rest_kept);
  line.add("handles", static_cast<double>(scene.handles.size()));
  line.add("handle_sq_error", error);
  line.add("handle_max_error", largest);
  line.add("satisfied", is_satisfied);
  if (!is_satisfied) line.add_problem("handles are not at their targets");
  if (!is_rest_kept) line.add_problem("vertices of the original mesh were moved at rest");
}

}  // namespace

int check(const CheckCall& call) {
  if (call.deformed.empty()) return check_animation(call.rest);
  const MeshFiles files = read_mesh_files(call.rest, call.deformed);
  CheckLine line;
  const bool is_injective = add_injectivity(files, line);
  add_distortion(files, line);
  if (call.scene) add_handles(load_scene_file(*call.scene).scene, files, line);
  std::cout << std::move(line).text();
  return is_injective ? kExitDone : kExitNotSatisfied;
}

}  // namespace foldless
