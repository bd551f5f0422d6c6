// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/newton_system.h"

#include <utility>

namespace foldless {

NewtonSystem::NewtonSystem(const MeshPair& mesh, const Constraints& constraints, Effort& effort)
    : effort_(&effort), objective_(mesh, constraints) {}

void NewtonSystem::rebuild(const MeshPair& mesh, const Constraints& constraints) {
  StageTimer timer(effort_->times.analyze);
  objective_ = Objective(mesh, constraints);
  factor_.forget_mesh();
  outdate_pattern();
}

void NewtonSystem::follow_flips(const MeshPair& mesh) {
  StageTimer timer(effort_->times.analyze);
  objective_.follow_flips(mesh);
  outdate_pattern();
}

Hessian NewtonSystem::take_hessian() {
  has_pattern_ = false;
  return std::move(hessian_);
}

void NewtonSystem::has_followed(Eigen::VectorXd following) {
  constexpr std::size_t kMost = 3;
  followings_.insert(followings_.begin(), std::move(following));
  if (followings_.size() > kMost) followings_.pop_back();
}

void NewtonSystem::outdate_pattern() {
  has_pattern_ = false;
  factor_.outdate_pattern();
}

void NewtonSystem::assemble(const Energy& energy, const Points& u, double clamping) {
  if (!has_pattern_) {
    StageTimer timer(effort_->times.analyze);
    hessian_.matrix = objective_.hessian_pattern();
    has_pattern_ = true;
  }
  StageTimer timer(effort_->times.assemble);
  first_order_ = objective_.assemble(energy, u, hessian_.matrix, clamping);
  const EnergySettings& settings = energy.settings;
  hessian_.kind = {settings.density, settings.beta, settings.reference, energy.constraints.held};
  factor_.outdate();
}

void NewtonSystem::assemble_gradient(const Energy& energy, const Points& u) {
  StageTimer timer(effort_->times.assemble);
  first_order_ = objective_.gradient(energy, u);
}

}  // namespace foldless
