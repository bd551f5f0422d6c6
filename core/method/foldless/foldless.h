// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/method/foldless/coarse_problem.h"
#include "core/method/foldless/other_ways.h"
#include "core/method/foldless/prescribed_regions.h"
#include "core/method/foldless/workspace.h"
#include "core/method/stepped_method.h"
#include "core/solve/descent.h"

namespace foldless {

/// The project's own method: keeps the paper's idea, the tessellation as a degree of freedom, and
/// replaces what holds it back. One vertex update a step. The README beside this file says what
/// the stages are for; solve() says who comes next. mesh() stays the best one so far while others
/// are tried.
///
/// Targets that move are pursued from the mesh as it is. Where the whole boundary of a component
/// has hard handles its edges are not split, and an approach that locks ends as
/// Outcome::infeasible if why_infeasible() has a proof, with its sentence for verdict(); the mesh
/// is as near as the approach brought it.
class Foldless final : public SteppedMethod {
 public:
  /// β per unit rest area: independent of the number of triangles, unlike the paper's.
  static constexpr double kBeta = 2;
  /// κ, the weight of the barrier that keeps boundary vertices from overlapping themselves.
  static constexpr double kGapWeight = 0.5;

  explicit Foldless(const Problem& problem, const CoarseSettings& dense = {});

  std::string verdict() const override { return verdict_; }
  const MeshPair& mesh() const override { return work_.mesh; }
  void set_targets(const Points& targets) override;

 private:
  /// What a run begins with.
  enum class Start {
    problem,  ///< the mesh of the problem
    drag      ///< the mesh as it is: somebody looks at it
  };

  Steps<Outcome> solve(Start start);
  /// Goes as far as Newton's steps on this mesh are not needed. The mesh if handles moved together;
  /// never in a drag.
  Steps<std::optional<MeshPair>> begin_cheaply(bool is_drag);
  Steps<> coarse_to_fine();
  Steps<Progress> solve_whitened();
  Steps<Progress> split_and_approach(FactorUse use);
  Steps<> forget_the_way();
  Steps<> look_for_better(OtherWays& ways);
  Steps<> try_other_maps(OtherWays& ways);
  Steps<> uncrush(OtherWays& ways);
  bool split_at_handles();
  bool is_proved_infeasible();
  bool do_handles_turn_together() const;

  const Problem problem_;
  const CoarseSettings dense_;
  bool is_coarse_ = false;  ///< a finer mesh takes the map over
  RunSettings settings_;
  Workspace work_;
  std::vector<PrescribedRegion> regions_;
  std::string verdict_;
};

}  // namespace foldless
