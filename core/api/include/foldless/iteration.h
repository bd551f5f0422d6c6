// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace foldless {

/// What made a vertex update.
enum class Phase {
  update,     ///< UpdateVertices of Algorithm 1 (4.2)
  relax,      ///< RelaxVertices of Algorithm 1 (4.2)
  approach,   ///< `foldless`: towards the targets under a growing penalty
  transport,  ///< `foldless`: handles carried along paths, the map's distortion forgotten
  pursue,     ///< `foldless`: handles carried to their targets, the mesh following
  construct,  ///< `foldless`: a map onto a held boundary, whatever it was before
  settle,     ///< `foldless`: at the targets, down to the minimum of the scene's energy
  coarse,     ///< `foldless`: one of these on a coarser mesh, from which the mesh will begin
  whitened,   ///< `foldless`: one of these with both planes seen through a linear map
  anew,       ///< `foldless`: one of these from rest, after a drag, for a shape without its way
  walk        ///< `foldless`: from the shape of a drag to that one
};

/// How a run ended.
enum class Outcome {
  gradient,  ///< eq. 7: ‖∇E‖² < ε_g
  step,      ///< eq. 8: the last update moved no vertex by ε_f or more, or gained too little
  iteration_limit,  ///< N_in or N_out reached
  infeasible,       ///< proved: no map meets the constraints, see Method::verdict()
  not_converged,    ///< ended without a map that meets them and without a proof
  cancelled,        ///< stopped from outside; the last valid mesh stands
  time_limit        ///< the same, because the time that was given is over
};

/// `gradient`, `step`, `iteration-limit`, `infeasible`, `not-converged`, `cancelled`,
/// `time-limit`: the words of report.json.
std::string_view name_of(Outcome outcome);
/// The words of iterations.csv: those of the enumeration.
std::string_view name_of(Phase phase);

/// The record of one vertex update: one row of iterations.csv. Lengths, areas and energies are
/// in the units of the input mesh; the counters are totals since the run began. In Phase::coarse,
/// Phase::whitened and Phase::anew it is that of the other mesh, which is not the one on show.
struct Iteration {
  int outer = 0;                         ///< round of the outer loop, from 0
  int inner = 0;                         ///< Update steps in this round so far
  Phase phase = Phase::update;           ///< subroutine that moved the vertices
  double distortion_energy = 0;          ///< E_d, eq. 3
  double penalty_energy = 0;             ///< α E_c = α‖Cu − p‖²
  double barrier_energy = 0;             ///< β E_b
  double energy = 0;                     ///< E, eq. 5, with the real targets
  double gradient_norm_squared = 0;      ///< ‖∇E‖², with the real targets
  double handle_error_squared = 0;       ///< ‖P(u)‖² = ‖Cu − p‖², soft handles left out
  double step_infinity_norm = 0;         ///< ‖u_n − u_{n−1}‖_∞
  double mu = 0;                         ///< shift of the diagonal in eq. 6
  double step_length = 0;                ///< t of the line search, in (0, 1]
  double min_area_ratio = 0;             ///< min over triangles of A′/A
  double max_conformal_distortion = 0;   ///< max over triangles of σ₁/σ₂
  double mean_conformal_distortion = 0;  ///< mean over triangles of σ₁/σ₂
  int factorizations = 0;                ///< H of Table 1: every attempt counts
  int updates = 0;                       ///< U of Table 1: every accepted update counts
  int flips = 0;                         ///< edges flipped so far
  int splits = 0;                        ///< edges split so far
  double seconds = 0;                    ///< processor time of the solving thread so far
};

}  // namespace foldless
