// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/anew.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/method/foldless/candidates.h"
#include "core/method/foldless/go_back.h"
#include "core/method/foldless/inner_run.h"
#include "core/method/foldless/settle.h"
#include "core/method/foldless/tidy.h"
#include "core/method/foldless/walk_over.h"

namespace foldless {
namespace starting_anew {

/// By which part E Kᵉ of what does not depend on the way may be higher: what only a way led to was
/// lower by 5 to 12 % where that was measured.
constexpr double kRise = 0.15;
/// A mesh of more triangles takes seconds from rest, which a hand that rests for a moment is not to
/// pay for.
constexpr int kLargestMesh = 50000;

/// The problem of the targets alone.
Problem at_rest(const Problem& problem, const Workspace& work, const Triangles& original) {
  Problem rest = problem;
  rest.mesh = MeshPair(original, work.mesh.rest().leftCols(original.maxCoeff() + 1));
  rest.mesh.set_deformed(rest.at_rest());
  rest.mesh.set_stiffness(problem.mesh.stiffness());
  for (int i = 0; i < work.constraints.count(); ++i)
    rest.handles[static_cast<std::size_t>(i)].target = work.constraints.targets.col(i);
  return rest;
}

/// Keeps the better one.
void choose(std::optional<Workspace>& best, Workspace other) {
  if (!best || merit_of(other) < merit_of(*best)) best = std::move(other);
}

/// The best shape from rest, of all ways that are cheap; nothing where none arrives. `start` has
/// the targets.
Steps<> search(const Problem& rest, const Solver& solver, const Workspace& start,
               std::optional<Workspace>& best) {
  Workspace other = start;
  Effort& effort = other.system.effort();
  const std::unique_ptr<SteppedMethod> run = solver(rest);
  co_await run_inside(*run, Phase::anew, effort);
  if (run->outcome() == Outcome::gradient) {
    other.set_mesh(run->mesh());
    co_await go_back(other, rest.mesh.triangles());
    choose(best, std::move(other));
  }
  if (rest.mesh.face_count() > kLargestWithCandidates) co_return;
  for (int i = 0; i < kCandidates; ++i) {
    other = start;
    other.set_mesh(rest.mesh);
    const std::optional<Progress> progress =
        co_await within(kMostOfACandidate, effort, candidate(i, other));
    if (progress != Progress::arrived) continue;
    co_await tidy(other);
    co_await go_back(other, rest.mesh.triangles());
    choose(best, std::move(other));
  }
}

}  // namespace starting_anew

bool does_way_matter(const std::vector<PrescribedRegion>& regions) {
  return std::ranges::any_of(regions, [](const PrescribedRegion& region) {
    return !region.inside.empty() || region.euler_characteristic != 1;
  });
}

Steps<> start_anew(Workspace& work, const Problem& problem, const Triangles& original,
                   const Solver& solver) {
  using namespace starting_anew;
  if (problem.mesh.face_count() > kLargestMesh) co_return;
  const Problem rest = at_rest(problem, work, original);
  std::optional<Workspace> best;
  Steps<> steps = search(rest, solver, work, best);
  co_await in_phase(Phase::anew, std::move(steps));
  if (best && merit_of(*best) <= (1 + kRise) * merit_of(work))
    co_await walk_over(work, std::move(best->mesh));
  co_yield [&work](Iteration& last) { work.measure_again(last, work.held_energy()); };
}

}  // namespace foldless
