// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace foldless {

/// Where the rotations come from that the first cone program of [Lip12] is convex about.
enum class StartFrames {
  rest,           ///< none: the rest state
  unconstrained,  ///< those of the energy's minimiser without constraints, which may fold
  continuation    ///< those of the map before, while the handles move to their targets in steps
};

/// The knobs of the solver, the paper's defaults (section 5). Constants that are not
/// dimensionless hold for a rest mesh whose bounding-box diagonal D is 1: a method brings D of the
/// part that it solves into them.
struct Parameters {
  std::string method = "foldless";   ///< a name of methods()
  double alpha = 5e7;                ///< weight of the penalty ‖Cu − p‖², eq. 5
  std::optional<double> beta;        ///< weight of the barrier, eq. 5; absent: the energy's default
  double delta = 1e-5;               ///< smallest A′/A, eq. 4, in (0, 1)
  double eta = 1e-3;                 ///< smallest relative decrease that flips an edge (4.3)
  int inner_iterations = 1000;       ///< N_in
  int outer_iterations = 10;         ///< N_out
  double gradient_tolerance = 1e-6;  ///< ε_g of eq. 7
  double step_tolerance = 1e-8;      ///< ε_f of eq. 8, in bounding-box diagonals
  bool condition_test = true;        ///< cancel flips that raise cond, eq. 10
  bool area_weighted = true;         ///< false: green-strain sums ψ without A_t, as [SKPSH13]
  StartFrames start = StartFrames::continuation;  ///< bounded-conformal only
  double distortion_bound = 100;                  ///< K ≥ σ₁/σ₂ of [Lip12] and [AL13], > 1

  bool operator==(const Parameters&) const = default;
};

}  // namespace foldless
