// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/foldless.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "core/method/foldless/anew.h"
#include "core/method/foldless/approach.h"
#include "core/method/foldless/approach_refined.h"
#include "core/method/foldless/candidates.h"
#include "core/method/foldless/coarse_hessian.h"
#include "core/method/foldless/common_motion.h"
#include "core/method/foldless/construct.h"
#include "core/method/foldless/go_back.h"
#include "core/method/foldless/hop.h"
#include "core/method/foldless/infeasible.h"
#include "core/method/foldless/inner_run.h"
#include "core/method/foldless/legs.h"
#include "core/method/foldless/pursue.h"
#include "core/method/foldless/refine_crushed.h"
#include "core/method/foldless/refine_distorted.h"
#include "core/method/foldless/rivals.h"
#include "core/method/foldless/tidy.h"
#include "core/method/foldless/transport_plans.h"
#include "core/method/foldless/whitened_problem.h"
#include "core/method/satisfied.h"
#include "core/multires/prolong.h"

namespace foldless {
namespace driver {

constexpr double kOffTarget = 1e-6;  ///< [D]
/// A vertex that is no farther from where it is at rest has not been moved. [D]
constexpr double kAtRest = 1e-10;
constexpr int kMostSplitRounds = 3;
constexpr double kGainOfASplitRound = 0.9;
/// Of a mesh of at most so many triangles,
constexpr int kLargestUncrushed = 2000;
/// so many other ways are tried where triangles are crushed.
constexpr int kWaysWhenCrushed = 6;

/// Vertices that came with the original mesh stay, and so do those before a handle, whose indices
/// must not change.
int first_removable_vertex(const Problem& problem) {
  int first = problem.original ? problem.original->vertices : problem.mesh.vertex_count();
  for (const Handle& handle : problem.handles) first = std::max(first, handle.vertex + 1);
  return first;
}

/// To rounding.
bool is_at_rest(const Problem& problem) {
  const double D = bounding_box_diagonal(problem.mesh.rest());
  return (problem.mesh.deformed() - problem.at_rest()).cwiseAbs().maxCoeff() <= kAtRest * D;
}

RunSettings settings_of(const Problem& problem) {
  RunSettings settings;
  settings.energy.density = problem.energy;
  settings.energy.alpha = problem.parameters.alpha;
  settings.energy.beta = problem.parameters.beta.value_or(Foldless::kBeta);
  settings.energy.delta = problem.parameters.delta;
  settings.energy.barrier_area_weighted = true;
  settings.energy.gap_weight = Foldless::kGapWeight;
  settings.eta = problem.parameters.eta;
  settings.condition_test = problem.parameters.condition_test;
  settings.diagonal = bounding_box_diagonal(problem.mesh.rest());
  settings.first_removable = first_removable_vertex(problem);
  return settings;
}

/// To make a coarse mesh of a large one, and to bring its map back, takes long; it is done again
/// with the next step when it was cancelled.
struct ChangeOfMesh {
  bool cancelled = false;
};
bool is_cancelled(const ChangeOfMesh& change) { return change.cancelled; }

}  // namespace driver

Foldless::Foldless(const Problem& problem, const CoarseSettings& dense)
    : problem_(problem),
      dense_(dense),
      settings_(driver::settings_of(problem_)),
      work_(problem_.mesh, constraints_of(problem_.handles), settings_, effort()),
      regions_(prescribed_regions(problem_.mesh, work_.constraints)) {
  settings_.fixed_boundary = boundary_vertices(regions_, work_.constraints);
  begin(solve(Start::problem));
}

void Foldless::set_targets(const Points& targets) {
  work_.constraints.targets = targets;
  verdict_.clear();
  begin(solve(Start::drag));
}

Steps<Outcome> Foldless::solve(Start start) {
  const bool is_drag = start == Start::drag;
  const std::optional<MeshPair> moved = co_await begin_cheaply(is_drag);
  const bool goes_on = is_drag || !driver::is_at_rest(problem_);
  const bool is_plain = is_drag || (!moved && legs_of(work_).size() == 1);

  Progress progress = Progress::arrived;
  if (work_.error() > 0) progress = co_await pursue(work_);
  const bool was_pursuit_locked = progress == Progress::locked;

  // Triangles that a pursuit pressed together lead to poor minima. The mesh of a drag goes on from
  // where it is, for somebody looks at it.
  if (progress == Progress::locked) {
    if (!is_drag) work_.set_mesh(moved ? *moved : problem_.mesh);
    progress = co_await approach(work_, FactorUse::lagged, legs_of(work_));
  }
  if (progress == Progress::locked && is_proved_infeasible()) co_return Outcome::infeasible;
  if (progress == Progress::locked && !is_drag) progress = co_await solve_whitened();
  if (progress == Progress::locked && !is_plain) {
    work_.set_mesh(problem_.mesh);
    progress = co_await approach(work_, FactorUse::lagged);
  }

  // Once more with the steps of Newton himself: some scenes are reached only so, but hardly those
  // whose handles turn.
  if (progress == Progress::locked && !is_drag && !do_handles_turn_together()) {
    work_.set_mesh(problem_.mesh);
    progress = co_await approach(work_, FactorUse::own);
  }
  if (progress == Progress::locked)
    progress = co_await split_and_approach(is_drag ? FactorUse::lagged : FactorUse::own);

  // Where no boundary is held as a whole nothing can be constructed.
  if (progress == Progress::locked && (goes_on || regions_.empty()))
    progress = co_await approach_refined(work_, is_drag ? work_.mesh : problem_.mesh);
  if (progress == Progress::locked) progress = co_await construct(work_, problem_.mesh, regions_);
  OtherWays ways(problem_, is_drag || !was_pursuit_locked);
  while (progress == Progress::locked && !ways.have_ended())
    progress = co_await ways.try_next(work_);
  if (progress == Progress::locked) {
    // The last record may be of another way.
    co_yield [this](Iteration& last) { work_.measure_again(last, work_.held_energy()); };
    co_return Outcome::step;
  }

  co_await tidy(work_);
  if (!is_drag && !goes_on && ways.has_cut_free()) co_await try_rivals(work_, ways);
  if (is_drag)
    co_await forget_the_way();
  else if (goes_on)
    co_await try_candidates(work_, problem_.mesh);
  else
    co_await look_for_better(ways);
  co_return Outcome::gradient;
}

// Where a hand rests its shape is not to tell on which way it came.
Steps<> Foldless::forget_the_way() {
  const auto original = original_triangles(problem_, settings_.first_removable);
  if (!original) co_return;
  co_await go_back(work_, *original);
  if (does_way_matter(regions_)) co_return;
  const Solver solver = [this](const Problem& problem) {
    return std::make_unique<Foldless>(problem, dense_);
  };
  co_await start_anew(work_, problem_, *original, solver);
}

// What the handles of a part do together costs no step. Where it is not all of their way the mesh
// leaps, so not while somebody looks at it.
Steps<std::optional<MeshPair>> Foldless::begin_cheaply(bool is_drag) {
  bool has_moved = false;
  if (work_.error() > 0) has_moved = co_await move_together(work_, CommonMotion::exact);
  if (is_drag) co_return std::nullopt;
  if (work_.error() > 0) co_await coarse_to_fine();
  if (work_.error() > 0) {
    const bool is_near = co_await move_together(work_, CommonMotion::near);
    has_moved = has_moved || is_near;
  }
  if (!has_moved) co_return std::nullopt;
  co_return work_.mesh;
}

// The paper's future work: Newton's steps are spent where they are cheap.
Steps<> Foldless::coarse_to_fine() {
  std::optional<CoarseProblem> coarse;
  const auto coarsen = [&](const std::stop_token& token) {
    coarse = coarse_problem(problem_, dense_, token);
    return driver::ChangeOfMesh{token.stop_requested()};
  };
  co_await vertex_update(coarsen);
  if (!coarse) co_return;
  Foldless run(coarse->problem, dense_);
  run.is_coarse_ = true;
  co_await run_inside(run, Phase::coarse, effort());
  if (run.outcome() != Outcome::gradient) co_return;
  std::optional<ProlongedMesh> fine;
  const auto prolong = [&](const std::stop_token& token) {
    fine = prolonged({run.mesh(), coarse->vertices}, work_.mesh, settings_.energy, token);
    return driver::ChangeOfMesh{token.stop_requested()};
  };
  co_await vertex_update(prolong);
  if (!fine) co_return;
  effort().flips += fine->flips;
  effort().splits += fine->splits;
  if (fine->splits == 0)
    work_.set_flipped_mesh(std::move(fine->mesh));
  else
    work_.set_mesh(std::move(fine->mesh));
  work_.system.factor().set_coarse(coarse_hessian(run.work_, fine->holding, work_.mesh));
}

// Where triangles are far longer than wide, as the linear map that makes the mesh round sees them.
Steps<Progress> Foldless::solve_whitened() {
  const std::optional<WhitenedProblem> whitened = whitened_problem(problem_);
  if (!whitened) co_return Progress::locked;
  Foldless run(whitened->problem, dense_);
  co_await run_inside(run, Phase::whitened, effort());
  if (run.outcome() != Outcome::gradient) co_return Progress::locked;
  std::optional<MeshPair> mesh = without_whitening(run.mesh(), whitened->map, problem_);
  if (!mesh) co_return Progress::locked;
  Workspace other = work_;
  other.set_mesh(*std::move(mesh));
  if (!other.is_feasible()) co_return Progress::locked;
  work_ = std::move(other);
  co_return Progress::arrived;
}

// The paper's splits, while a round gains a tenth.
Steps<Progress> Foldless::split_and_approach(FactorUse use) {
  using namespace driver;
  double locked_error = std::numeric_limits<double>::infinity();
  for (int round = 0; round < kMostSplitRounds; ++round) {
    if (work_.error() >= kGainOfASplitRound * locked_error) break;
    locked_error = work_.error();
    if (!split_at_handles()) break;
    ++effort().rounds;
    const Progress progress = co_await approach(work_, use);
    if (progress == Progress::arrived) co_return progress;
  }
  co_return Progress::locked;
}

// Not of a mesh that goes on from another, which is the next picture of a film: it would jump. The
// other maps of a coarse mesh are hardly ever those that the fine one ends in.
Steps<> Foldless::look_for_better(OtherWays& ways) {
  if (largest_distortion(work_.mesh) <= kHardlyDistorted) co_return;
  if (!is_coarse_) co_await try_other_maps(ways);
  co_await refine_crushed(work_);
  co_await refine_distorted(work_);
}

// Other ways from rest lead farther from a crushed mesh than hops, so they come first there.
Steps<> Foldless::try_other_maps(OtherWays& ways) {
  const bool was_crushed = is_crushed(work_.mesh);
  if (!was_crushed) co_await hop(work_);
  co_await try_candidates(work_, problem_.mesh);
  co_await uncrush(ways);
  if (was_crushed) co_await hop(work_);
}

// Where triangles are crushed another way, from rest, may end in a better mesh; the best one stays.
Steps<> Foldless::uncrush(OtherWays& ways) {
  using namespace driver;
  if (problem_.mesh.face_count() > kLargestUncrushed || !is_crushed(work_.mesh)) co_return;
  for (int i = 0; i < kWaysWhenCrushed && !ways.have_ended() && is_crushed(work_.mesh); ++i) {
    Workspace other = work_;
    const Progress progress = co_await ways.try_next(other);
    if (progress == Progress::locked) continue;
    co_await tidy(other);
    if (largest_distortion(other.mesh) < largest_distortion(work_.mesh)) work_ = std::move(other);
  }
  co_yield [this](Iteration& last) { work_.measure_again(last, work_.held_energy()); };
}

bool Foldless::split_at_handles() {
  std::vector<MovingDirection> directions;
  for (int i = 0; i < work_.constraints.count(); ++i) {
    const auto row = static_cast<std::size_t>(i);
    const int v = work_.constraints.vertices[row];
    const Vec2 direction = work_.constraints.targets.col(i) - work_.mesh.deformed().col(v);
    if (!work_.constraints.soft[row] && direction.norm() > driver::kOffTarget * settings_.diagonal)
      directions.push_back({v, direction});
  }
  return work_.split_edges(directions) > 0;
}

// Handles within the tolerance of a target that is exactly out of reach are at it.
bool Foldless::is_proved_infeasible() {
  if (work_.error() <= kSatisfied * settings_.diagonal * settings_.diagonal) return false;
  std::optional<std::string> why = why_infeasible(regions_, work_.constraints);
  if (!why) return false;
  verdict_ = *std::move(why);
  return true;
}

bool Foldless::do_handles_turn_together() const {
  return turn_together(handle_positions(work_.constraints, problem_.at_rest()),
                       work_.constraints.targets);
}

}  // namespace foldless
