// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/method/stepped_method.h"
#include "core/remesh/flip_edges.h"
#include "core/solve/damped_system.h"

namespace foldless {

/// Which remeshing Algorithm 1 may use.
struct Remeshing {
  bool flips = true;    ///< FlipEdges after every Update: Ours(F) of Table 1; off: Ours(NF)
  bool splits = false;  ///< SplitEdges where the inner loop leaves handles off their targets
};

/// Algorithm 1 of the paper, one vertex update a step. Lengths are in units of D, the diagonal of
/// the rest mesh, whatever that is.
class RemeshingAssisted final : public SteppedMethod {
 public:
  RemeshingAssisted(const Problem& problem, Remeshing remeshing);

  const MeshPair& mesh() const override { return mesh_; }
  void set_targets(const Points& targets) override;

 private:
  /// How a round, the inner loop of Algorithm 1, ended.
  struct RoundEnd {
    Outcome outcome = Outcome::step;
    bool is_last_step_small = false;
    bool has_changed_mesh = false;  ///< something moved or flipped
    Points handles_before;          ///< the handles before the last update, 2 × #handles
  };

  Steps<Outcome> algorithm_1();
  Steps<RoundEnd> inner_loop(int outer);
  Steps<bool> relax(int outer, int inner);
  std::optional<Outcome> convergence(const VertexUpdate& update) const;
  bool is_gradient_small() const;
  bool is_small(const VertexUpdate& update) const;
  bool is_satisfied() const;
  double error() const;
  int flip();
  int split(const RoundEnd& round);
  void go_back_to(const MeshPair& mesh);
  Iteration record(const VertexUpdate& update, Phase phase) const;

  MeshPair mesh_;
  Parameters parameters_;
  Remeshing remeshing_;
  double diagonal_;  ///< D
  Energy energy_;
  DampedSystem system_;
};

/// The energy that a problem's parameters ask for, with D of its rest mesh in the constants that
/// the paper chose for D = 1. The mean rest area turns the paper's β for energies that it sums
/// unweighted into the β of the weighted sum.
EnergySettings energy_settings(const Problem& problem);

/// ε_g of eq. 7 in the unit of ‖∇E‖²: E grows with the square of D, and ∇E with D.
double gradient_tolerance(const Parameters& parameters, double diagonal);

}  // namespace foldless
