// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/record.h"

#include "core/mesh/quality.h"

namespace foldless {

void measure(Iteration& iteration, const NewtonSystem& system, const MeshPair& mesh,
             const Energy& energy) {
  EnergyTerms terms = system.energy();
  Constraints free = energy.constraints;
  free.held = false;
  terms.penalty = energy.settings.alpha * penalty(free, mesh.deformed());
  const Quality quality = quality_of(mesh.triangles(), mesh.rest(), mesh.deformed());
  iteration.distortion_energy = terms.distortion;
  iteration.penalty_energy = terms.penalty;
  iteration.barrier_energy = terms.barrier;
  iteration.energy = terms.total();
  iteration.gradient_norm_squared = system.gradient().squaredNorm();
  iteration.handle_error_squared = handle_error_squared(energy.constraints, mesh.deformed());
  iteration.min_area_ratio = quality.min_area_ratio;
  iteration.max_conformal_distortion = quality.max_conformal_distortion;
  iteration.mean_conformal_distortion = quality.mean_conformal_distortion;
}

Iteration record_of(const VertexUpdate& update, const NewtonSystem& system, const MeshPair& mesh,
                    const Energy& energy) {
  Iteration iteration;
  measure(iteration, system, mesh, energy);
  iteration.step_infinity_norm = update.step_infinity_norm;
  iteration.mu = update.mu;
  iteration.step_length = update.step_length;
  const Effort& effort = system.effort();
  iteration.factorizations = effort.factorizations;
  iteration.updates = effort.updates;
  iteration.flips = effort.flips;
  iteration.splits = effort.splits;
  return iteration;
}

}  // namespace foldless
