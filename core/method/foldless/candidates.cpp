// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/candidates.h"

#include <algorithm>
#include <utility>

#include "core/method/foldless/approach.h"
#include "core/method/foldless/legs.h"
#include "core/method/foldless/tidy.h"
#include "core/method/foldless/transport.h"
#include "core/method/foldless/transport_plans.h"

namespace foldless {
namespace candidates {

/// E_d is better below this part of another.
constexpr double kLower = 0.999;
/// A lower E_d is worth so many times the largest σ₁/σ₂.
constexpr double kMoreDistorted = 1.5;
/// Where σ₁/σ₂ of a triangle is above this another way often ends in a better shape.
constexpr double kSuspiciousDistortion = 100;
static_assert(kSuspiciousDistortion > kHardlyDistorted);
constexpr int kFewLegs = 2;
constexpr int kManyLegs = 8;

/// A step of steps that may be left before their end.
struct TrialStep {
  bool cancelled = false;
};
bool is_cancelled(const TrialStep& step) { return step.cancelled; }

double distortion_energy(const Workspace& work) {
  return work.system.objective().value(work.held_energy(), work.mesh.deformed()).distortion;
}

}  // namespace candidates

Steps<Progress> candidate(int which, Workspace& work) {
  using namespace candidates;
  if (which == 1)
    return transport(work, transport_plans(work.handles(), work.constraints.targets, 0).front());
  return approach(work, FactorUse::lagged, straight_legs(work, which == 0 ? kFewLegs : kManyLegs));
}

Steps<> try_candidates(Workspace& work, const MeshPair& start) {
  if (start.face_count() > kLargestWithCandidates ||
      largest_distortion(work.mesh) <= candidates::kSuspiciousDistortion)
    co_return;
  const double most_distortion = most_distortion_beside(work.mesh);
  bool has_changed = false;
  for (int i = 0; i < kCandidates; ++i) {
    Workspace other = work;
    other.set_mesh(start);
    const auto progress =
        co_await within(kMostOfACandidate, work.system.effort(), candidate(i, other));
    if (progress != Progress::arrived) continue;
    co_await tidy(other);
    if (largest_distortion(other.mesh) > most_distortion || !has_less_energy(other, work)) continue;
    work = std::move(other);
    has_changed = true;
  }
  if (has_changed) co_await tidy(work);
  co_yield [&work](Iteration& last) { work.measure_again(last, work.held_energy()); };
}

Steps<std::optional<Progress>> within(int most_factorizations, const Effort& effort,
                                      Steps<Progress> steps) {
  const int last = effort.factorizations + most_factorizations;
  StepContext own;
  steps.begin(own);
  const auto next = [&own](const std::stop_token& token) {
    return candidates::TrialStep{!own.request->make(token)};
  };
  while (!steps.have_ended()) {
    if (effort.factorizations >= last) co_return std::nullopt;
    own.record.reset();
    co_await vertex_update(next);
    own.waiting.resume();
    if (own.record) co_yield *own.record;
  }
  co_return steps.result();
}

bool has_less_energy(const Workspace& work, const Workspace& other) {
  return candidates::distortion_energy(work) <
         candidates::kLower * candidates::distortion_energy(other);
}

double most_distortion_beside(const MeshPair& mesh) {
  const double distortion = largest_distortion(mesh);
  return std::max(distortion, std::min(candidates::kMoreDistorted * distortion, kCrushed));
}

}  // namespace foldless
