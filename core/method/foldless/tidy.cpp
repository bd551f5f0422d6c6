// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/tidy.h"

#include <utility>

namespace foldless {
namespace {

/// What flips and moves make of the mesh lets more vertices go in a second and third round.
constexpr int kMostRounds = 3;
/// By which part of E a vertex may raise it when it goes; moves take most of it back.
constexpr double kRiseOfAVertex = 1e-2;
/// By which part of E a round may raise it in the end.
constexpr double kRiseOfARound = 1e-2;
constexpr double kLargestDistortion = 1e3;

}  // namespace

Tidy::Tidy(Workspace& workspace, int first_removable)
    : first_removable_(first_removable), settle_(workspace) {}

Progress Tidy::step(Workspace& workspace, std::stop_token token, VertexUpdate& update) {
  const Progress progress = settle_.step(workspace, token, update);
  if (progress != Progress::arrived) return progress;
  if (!begin_round(workspace)) return Progress::arrived;
  settle_ = Settle(workspace);
  return Progress::running;
}

bool Tidy::begin_round(Workspace& workspace) {
  const double energy = settle_.energy_of(workspace);
  if (before_ && !(energy <= (1 + kRiseOfARound) * before_->energy)) {
    workspace.set_mesh(std::move(before_->mesh));
    before_.reset();
    return false;
  }
  if (rounds_++ >= kMostRounds || first_removable_ >= workspace.mesh.vertex_count()) return false;
  before_ = Before{workspace.mesh, energy};
  return workspace.collapse_edges({.energy = workspace.system.objective().settings(),
                                   .first_removable = first_removable_,
                                   .largest_rise = kRiseOfAVertex * energy,
                                   .largest_distortion = kLargestDistortion}) > 0;
}

}  // namespace foldless
