// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/tidy.h"

#include <utility>

#include "core/mesh/quality.h"

namespace foldless {
namespace {

/// What flips and moves make of the mesh lets more vertices go in a second and third round.
constexpr int kMostRounds = 3;
/// By which part of E a vertex may raise it when it goes; moves take most of it back.
constexpr double kRiseOfAVertex = 1e-2;
/// By which part a round may raise E Kᵉ in the end.
constexpr double kRiseOfARound = 1e-2;
/// A mesh that was refined has more vertices than anybody asked for, and a lower E for it: while
/// more than this part of the original ones was added,
constexpr double kCrowded = 0.1;
/// they go for more of it.
constexpr int kMostCrowdedRounds = 10;
constexpr double kRiseOfACrowdedVertex = 0.1;
/// and with a triangle that is crushed by no more than this; settling mends most of them.
constexpr double kLargestDistortionWhenCrowded = 10 * Tidy::kCrushed;
constexpr double kRiseOfACrowdedRound = 1;
constexpr double kLargeExponent = 0.2;

}  // namespace

Tidy::Tidy(Workspace& workspace, int first_removable)
    : first_removable_(first_removable), settle_(workspace) {}

Progress Tidy::step(Workspace& workspace, std::stop_token token, VertexUpdate& update) {
  const Progress progress = settle_.step(workspace, token, update);
  if (progress != Progress::arrived) return progress;
  if (is_collapsing_ && collapse(workspace)) {
    settle_ = Settle(workspace);
    return Progress::running;
  }
  return begin_uncrushing(workspace) ? Progress::running : Progress::arrived;
}

bool Tidy::is_crowded(const MeshPair& mesh) const {
  return mesh.vertex_count() > (1 + kCrowded) * first_removable_;
}

bool Tidy::collapse(Workspace& workspace) {
  if (first_removable_ >= workspace.mesh.vertex_count()) return false;
  const double merit = settle_.merit_of(workspace);
  const double rise = before_ && is_crowded(before_->mesh) ? kRiseOfACrowdedRound : kRiseOfARound;
  if (before_ && !(merit <= (1 + rise) * before_->merit)) {
    workspace.set_mesh(std::move(before_->mesh));
    return false;
  }
  const bool crowded = is_crowded(workspace.mesh);
  if (rounds_++ >= (crowded ? kMostCrowdedRounds : kMostRounds)) return false;
  before_ = Before{workspace.mesh, merit};
  return workspace.collapse_edges(
             {.energy = workspace.system.objective().settings(),
              .first_removable = first_removable_,
              .largest_rise =
                  (crowded ? kRiseOfACrowdedVertex : kRiseOfAVertex) * settle_.energy_of(workspace),
              .largest_distortion = crowded ? kLargestDistortionWhenCrowded : kCrushed}) > 0;
}

bool Tidy::begin_uncrushing(Workspace& workspace) {
  const MeshPair& mesh = workspace.mesh;
  if (!std::exchange(is_collapsing_, false)) return false;
  before_.reset();
  if (quality_of(mesh.triangles(), mesh.rest(), mesh.deformed()).max_conformal_distortion <
      kCrushed)
    return false;
  settle_ = Settle(workspace, kLargeExponent);
  return true;
}

}  // namespace foldless
