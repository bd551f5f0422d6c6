// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/method/foldless/approach.h"
#include "core/method/foldless/attempt.h"
#include "core/method/foldless/coarse.h"
#include "core/method/foldless/held_regions.h"
#include "core/method/foldless/other_ways.h"
#include "core/method/foldless/pursue.h"
#include "core/method/foldless/tidy.h"
#include "core/method/method.h"

namespace foldless {

/// The project's own method: keeps the paper's idea, the tessellation as a degree of freedom, and
/// replaces what holds it back. One vertex update a step. The problem's rest mesh has a
/// bounding-box diagonal of about 1.
///
/// A dense mesh begins with the map of a coarser one, see Coarse; until that is there mesh() stays
/// what it was. Pursue → Tidy where nothing is in the way; else Approach → Tidy, from the
/// beginning. A locked approach splits edges at the handles that are not home and begins again;
/// when that gains no more, OtherWays are tried on a second mesh, while mesh() stays the best one
/// so far. Targets that move are pursued from the mesh as it is.
///
/// Where the whole boundary of a component is held its edges are not split, and an approach that
/// locks ends as Outcome::infeasible if why_infeasible() has a proof, with its sentence for
/// verdict(); the mesh is as near as the approach brought it. A mesh with crushed triangles is not
/// the last word: some more ways are tried, and the best mesh stays.
class Foldless final : public Method {
 public:
  /// β per unit rest area: independent of the number of triangles, unlike the paper's.
  static constexpr double kBeta = 2;

  explicit Foldless(Problem problem, const CoarseSettings& dense = {});

  std::unique_ptr<Method> clone() const override;
  std::optional<Iteration> step(std::stop_token token) override;
  std::optional<Outcome> outcome() const override { return outcome_; }
  std::string verdict() const override { return verdict_; }
  const MeshPair& mesh() const override { return work_.mesh; }
  void set_targets(const Points& targets) override;
  StageTimes times() const override { return work_.system.times; }

 private:
  using Stage = std::variant<Approach, Attempt, Coarse, Pursue, Tidy>;

  Stage first_stage();
  std::optional<Iteration> advance(std::stop_token token);
  std::optional<Iteration> approach(Approach& stage, std::stop_token token);
  std::optional<Iteration> attempt(Attempt& attempt, std::stop_token token);
  std::optional<Iteration> coarse(Coarse& stage, std::stop_token token);
  std::optional<Iteration> pursue(Pursue& stage, std::stop_token token);
  std::optional<Iteration> settle(Tidy& stage, std::stop_token token);
  Iteration record(Workspace& work, const VertexUpdate& update, const Positions& positions);
  void after_tidying();
  void end_satisfied();
  void after_locked_pursuit();
  void after_locked_approach();
  void after_locked_attempt(Attempt& attempt);
  void begin_next_attempt();
  /// Where an attempt starts: what moves is at rest.
  MeshPair at_rest() const;
  bool split();
  bool is_satisfied(double error) const;
  bool prove_infeasible();

  MeshPair initial_;      ///< where attempts start: its rest state
  bool is_drag_ = false;  ///< targets moved since the beginning
  int first_removable_;   ///< vertices of lower index stay
  EnergySettings energy_;
  Workspace work_;
  std::vector<HeldRegion> held_regions_;  ///< of initial_
  Stage stage_;
  std::optional<Outcome> outcome_;
  std::string verdict_;
  int inner_ = 0;
  int split_rounds_ = 0;
  OtherWays other_ways_;                ///< since the targets moved
  std::optional<Workspace> satisfied_;  ///< the best so far, while more is tried
  int attempts_when_crushed_ = 0;
  double locked_error_ = 0;  ///< ‖P‖² when the approach locked last
  double seconds_ = 0;
};

}  // namespace foldless
