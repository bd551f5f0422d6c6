// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy/positions.h"
#include "core/method/method.h"
#include "core/remesh/flip_edges.h"
#include "core/solve/newton_system.h"
#include "core/solve/update_vertices.h"

namespace foldless {

/// Which remeshing Algorithm 1 may use.
struct Remeshing {
  bool flips = true;    ///< FlipEdges after every Update: Ours(F) of Table 1; off: Ours(NF)
  bool splits = false;  ///< SplitEdges where the inner loop leaves handles off their targets
};

/// Algorithm 1 of the paper, one vertex update a step. The problem's rest mesh has a bounding-box
/// diagonal of about 1.
class RemeshingAssisted final : public Method {
 public:
  RemeshingAssisted(Problem problem, Remeshing remeshing);

  std::unique_ptr<Method> clone() const override;
  std::optional<Iteration> step(std::stop_token token) override;
  std::optional<Outcome> outcome() const override { return outcome_; }
  const MeshPair& mesh() const override { return mesh_; }
  void set_targets(const Points& targets) override;
  StageTimes times() const override { return system_.times; }

 private:
  std::optional<Iteration> advance(std::stop_token token);
  Iteration after_relaxing(const VertexUpdate& update);
  Iteration after_updating(const VertexUpdate& update);
  std::optional<Outcome> convergence(const VertexUpdate& update) const;
  void end_inner_loop(Outcome outcome);
  void begin_round();
  bool prepare_next_round(Outcome outcome);
  int split(Outcome outcome);
  void go_back_to_best();
  bool has_stalled();
  bool is_small(const VertexUpdate& update) const;
  bool is_satisfied() const;
  int flip();
  Iteration record(const VertexUpdate& update, Phase phase);

  MeshPair mesh_;
  Parameters parameters_;
  Remeshing remeshing_;
  FlipSettings flip_settings_;
  double diagonal_;  ///< D of the rest mesh
  Positions positions_;
  NewtonSystem system_;

  std::optional<Outcome> outcome_;
  Phase phase_ = Phase::update;  ///< subroutine that the next step begins with
  int outer_ = 0;
  int inner_ = 0;
  bool round_changed_mesh_ = false;  ///< something moved or flipped in this outer round
  double round_start_error_ = 0;     ///< ‖P‖² when the outer round began
  int flips_ = 0;
  int splits_ = 0;
  Points handles_before_;  ///< where the handles were before the last update, 2 × #handles
  bool is_last_step_small_ = false;
  /// The best end of a round so far, to which a round of splits that gained nothing goes back.
  struct Best {
    MeshPair mesh;
    double error;  ///< ‖P‖²
  };
  std::optional<Best> best_;
  int rounds_without_gain_ = 0;
  double watched_error_ = 0;  ///< ‖P‖² when the watch for a stall began
  double seconds_ = 0;
};

/// The energy that a problem's parameters ask for. The mean rest area turns the paper's β for
/// energies that it sums unweighted into the β of the weighted sum.
EnergySettings energy_settings(const Problem& problem);

}  // namespace foldless
