// SPDX-License-Identifier: GPL-3.0-or-later
// The solver's kernels on a disk that is being twisted; the argument is the number of triangles.
#include <benchmark/benchmark.h>

#include "core/mesh/injective.h"
#include "core/method/methods.h"
#include "core/method/remeshing_assisted.h"
#include "core/remesh/flip_edges.h"
#include "core/run/run.h"
#include "core/solve/damped_system.h"
#include "core/solve/line_search.h"
#include "core/solve/newton_step.h"
#include "tests/benchmarks/turned_disk.h"

namespace foldless::benchmarks {
namespace {

constexpr double kTwist = 60;

/// The twist after a few iterations, when its triangles are well distorted.
struct Twist {
  explicit Twist(int faces)
      : problem(turned_disk(faces, kTwist)),
        energy{energy_settings(problem), constraints_of(problem.handles)} {
    const auto method = find_method("paper-noflip")->start(problem);
    for (int i = 0; i < 5; ++i) method->step({});
    problem.mesh = method->mesh();
  }

  Problem problem;
  Energy energy;
};

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(500)->Arg(5000)->Arg(50000)->Unit(benchmark::kMillisecond);
}

void report_triangles(benchmark::State& state, const MeshPair& mesh) {
  state.counters["triangles"] = mesh.face_count();
}

void assemble(benchmark::State& state) {
  const Twist twist(static_cast<int>(state.range(0)));
  Effort effort;
  NewtonSystem system(twist.problem.mesh, twist.energy.constraints, effort);
  for (auto _ : state) system.assemble(twist.energy, twist.problem.mesh.deformed());
  report_triangles(state, twist.problem.mesh);
}
BENCHMARK(assemble)->Apply(sizes);

void analyze(benchmark::State& state) {
  const Twist twist(static_cast<int>(state.range(0)));
  const Objective objective(twist.problem.mesh, twist.energy.constraints);
  const SparseSymmetric pattern = objective.hessian_pattern();
  for (auto _ : state) Cholesky().analyze(pattern);
  report_triangles(state, twist.problem.mesh);
}
BENCHMARK(analyze)->Apply(sizes);

void analyze_again(benchmark::State& state) {
  const Twist twist(static_cast<int>(state.range(0)));
  const Objective objective(twist.problem.mesh, twist.energy.constraints);
  const SparseSymmetric pattern = objective.hessian_pattern();
  Cholesky cholesky;
  cholesky.analyze(pattern);
  for (auto _ : state) cholesky.analyze(pattern);
  report_triangles(state, twist.problem.mesh);
}
BENCHMARK(analyze_again)->Apply(sizes);

/// Its Hessian, and how much more on the diagonal makes it positive definite.
struct TwistedHessian {
  explicit TwistedHessian(const Twist& twist) {
    const Objective objective(twist.problem.mesh, twist.energy.constraints);
    matrix = objective.hessian_pattern();
    objective.assemble(twist.energy, twist.problem.mesh.deformed(), matrix);
    cholesky.analyze(matrix);
  }
  bool factorize() { return cholesky.factorize(matrix, kShift); }

  static constexpr double kShift = 1e4;
  SparseSymmetric matrix;
  Cholesky cholesky;
};

void factorize(benchmark::State& state) {
  const Twist twist(static_cast<int>(state.range(0)));
  TwistedHessian hessian(twist);
  for (auto _ : state)
    if (!hessian.factorize()) state.SkipWithError("not positive definite");
  report_triangles(state, twist.problem.mesh);
}
BENCHMARK(factorize)->Apply(sizes);

void precondition(benchmark::State& state) {
  const Twist twist(static_cast<int>(state.range(0)));
  TwistedHessian hessian(twist);
  if (!hessian.factorize()) state.SkipWithError("not positive definite");
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(hessian.matrix.size(), -1, 2);
  for (auto _ : state) benchmark::DoNotOptimize(hessian.cholesky.precondition(b));
  report_triangles(state, twist.problem.mesh);
}
BENCHMARK(precondition)->Apply(sizes);

void search_line(benchmark::State& state) {
  const Twist twist(static_cast<int>(state.range(0)));
  const MeshPair& mesh = twist.problem.mesh;
  Effort effort;
  DampedSystem system(mesh, twist.energy.constraints, effort);
  system.assemble(twist.energy, mesh.deformed());
  if (!system.factorize_damped(false, {})) state.SkipWithError("no factor");
  const Points step = newton_step(system);
  const Line line{mesh.deformed(), step, system.energy().total(), slope(system, step)};
  for (auto _ : state)
    benchmark::DoNotOptimize(line_search(system.objective(), twist.energy, line));
  report_triangles(state, mesh);
}
BENCHMARK(search_line)->Apply(sizes);

void scan_for_flips(benchmark::State& state) {
  const Twist twist(static_cast<int>(state.range(0)));
  const FlipSettings settings{twist.energy.settings, 1e-3, true};
  MeshPair mesh = twist.problem.mesh;
  flip_edges(mesh, settings);  // from here on there is nothing to flip
  for (auto _ : state) benchmark::DoNotOptimize(flip_edges(mesh, settings));
  report_triangles(state, mesh);
}
BENCHMARK(scan_for_flips)->Apply(sizes);

void split_edge(benchmark::State& state) {
  const MeshPair start = turned_disk(static_cast<int>(state.range(0)), kTwist).mesh;
  MeshPair mesh = start;
  constexpr int kMostSplits = 10000;  // then from the start again: the mesh should not grow much
  int edge = 0;
  for (auto _ : state) {
    if (edge == kMostSplits || edge == start.edge_count()) {
      state.PauseTiming();
      mesh = start;
      edge = 0;
      state.ResumeTiming();
    }
    benchmark::DoNotOptimize(mesh.split_edge(edge++, 0.5));
  }
  report_triangles(state, start);
}
BENCHMARK(split_edge)->Arg(5000)->Arg(50000)->Arg(500000)->Unit(benchmark::kMicrosecond);

void prove_injective(benchmark::State& state) {
  const Twist twist(static_cast<int>(state.range(0)));
  const MeshPair& mesh = twist.problem.mesh;
  const InjectivityChecker checker(mesh.triangles(), mesh.vertex_count());
  for (auto _ : state) benchmark::DoNotOptimize(checker.is_injective(mesh.deformed()));
  report_triangles(state, mesh);
}
BENCHMARK(prove_injective)->Apply(sizes);

void solve(benchmark::State& state) {
  const Problem problem = turned_disk(static_cast<int>(state.range(0)), kTwist);
  int factorizations = 0;
  for (auto _ : state) {
    Run run(problem);
    while (const auto iteration = run.step({})) factorizations = iteration->factorizations;
  }
  report_triangles(state, problem.mesh);
  state.counters["factorizations"] = factorizations;
}
BENCHMARK(solve)->Arg(500)->Arg(5000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace foldless::benchmarks
