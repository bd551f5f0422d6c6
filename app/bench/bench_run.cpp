// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/bench_run.h"

#include <exception>
#include <limits>
#include <new>

#include "app/bench/drag_run.h"
#include "core/energy/constraints.h"
#include "core/energy/element.h"
#include "core/mesh/injective.h"
#include "core/mesh/quality.h"
#include "core/method/satisfied.h"
#include "core/run/active_part.h"
#include "core/run/run.h"
#include "core/stage_times.h"

namespace foldless {
namespace {

constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();

Problem problem_of(const BenchJob& job) {
  const Scene& scene = job.scene->scene;
  Problem problem{.mesh = mesh_of(scene),
                  .energy = scene.energy,
                  .handles = scene.handles,
                  .parameters = job.parameters};
  problem.original = OriginalMesh{std::make_shared<const Triangles>(scene.triangles),
                                  static_cast<int>(scene.rest.cols())};
  return problem;
}

double distortion_energy(const Density& energy, const MeshPair& mesh) {
  double sum = 0;
  for (const auto t : mesh.triangles().colwise()) {
    const RestElement rest = rest_element(mesh, t);
    sum += rest.stiffness * rest.area *
           energy.value(deformation_gradient(mesh.rest(), mesh.deformed(), t));
  }
  return sum;
}

void measure(const Problem& problem, const Snapshot& state, BenchRow& row) {
  const InjectivityChecker checker(*state.triangles, static_cast<int>(state.rest->cols()));
  const InjectivityReport report = checker.check(state.deformed);
  row.is_valid = report.is_injective_inside() && checker.is_injective_inside(*state.rest);
  row.overlapping_boundary_vertices = static_cast<int>(report.overlapping_boundary_vertices.size());
  row.handle_error_squared = handle_error_squared(constraints_of(state.handles), state.deformed);
  MeshPair mesh(*state.triangles, *state.rest, state.deformed);
  mesh.set_stiffness(problem.mesh.stiffness());
  row.distortion_energy = distortion_energy(*problem.energy, mesh);
  row.vertices_added = static_cast<int>(state.rest->cols()) - row.vertices;
  if (!row.is_valid) {
    row.max_conformal_distortion = row.mean_conformal_distortion = kUndefined;
    return;
  }
  const Quality quality = quality_of(*state.triangles, *state.rest, state.deformed);
  row.max_conformal_distortion = quality.max_conformal_distortion;
  row.mean_conformal_distortion = quality.mean_conformal_distortion;
}

void run_to_its_end(const BenchJob& job, const std::stop_token& token, BenchRow& row) {
  const Problem problem = problem_of(job);
  const double start = thread_seconds();
  Run run(problem);
  if (job.scene->targets.empty())
    while (const auto record = run.step(token)) row.iterations.push_back(*record);
  else
    run_drag(job, run, token, row);
  row.seconds = thread_seconds() - start;
  row.outcome = name_of(run.outcome().value_or(Outcome::cancelled));
  row.is_satisfied = run.is_satisfied();
  if (!row.iterations.empty()) row.last = row.iterations.back();
  measure(problem, *run.snapshot(), row);
}

}  // namespace

BenchRow run_job(const BenchJob& job, const std::stop_token& token) {
  const Scene& scene = job.scene->scene;
  BenchRow row;
  row.scene = job.scene->name;
  row.difficulty = job.scene->difficulty;
  row.energy = scene.energy->name;
  row.method = job.parameters.method;
  row.parameters = job.parameters;
  row.vertices = static_cast<int>(scene.rest.cols());
  row.faces = static_cast<int>(scene.triangles.cols());
  row.diagonal = active_diagonal(scene.triangles, scene.rest, scene.handles);
  try {
    run_to_its_end(job, token, row);
  } catch (const std::bad_alloc&) {
    throw;  // says nothing of the method, and may go well another time
  } catch (const std::exception& error) {
    row.outcome = "refused";
    row.note = error.what();
  }
  return row;
}

}  // namespace foldless
