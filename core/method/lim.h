// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy/positions.h"
#include "core/method/method.h"
#include "core/solve/newton_system.h"
#include "core/solve/update_vertices.h"

namespace foldless {

/// Locally injective mappings [SKPSH13], one vertex update a step: damped Newton steps on E of
/// eq. 5, the whole mesh, no remeshing. When the Hessian had to be shifted by μ, the targets of the
/// step are t p + (1 − t) C u with t = 1/(1 + μ²): sub-stepping.
///
/// Triangles are tested where a step ends and not on the way: they stay positive, but a step may
/// jump so far that they cover the surroundings of an interior vertex twice, which verdict()
/// says.
/// The problem's rest mesh has a bounding-box diagonal of about 1.
class Lim final : public Method {
 public:
  explicit Lim(Problem problem);

  std::unique_ptr<Method> clone() const override;
  std::optional<Iteration> step(std::stop_token token) override;
  std::optional<Outcome> outcome() const override { return outcome_; }
  std::string verdict() const override { return verdict_; }
  const MeshPair& mesh() const override { return mesh_; }
  void set_targets(const Points& targets) override;
  StageTimes times() const override { return system_.times; }

 private:
  VertexUpdate update(std::stop_token token);
  VertexUpdate move_along(const Points& step, const Positions& positions);
  std::optional<Outcome> convergence(const VertexUpdate& update) const;

  MeshPair mesh_;
  Parameters parameters_;
  double diagonal_;  ///< D of the rest mesh
  Positions positions_;
  NewtonSystem system_;

  std::optional<Outcome> outcome_;
  std::string verdict_;
  double step_scale_ = 1;  ///< first trial of the next line search, in (0, 1]
  int inner_ = 0;
  double seconds_ = 0;
};

}  // namespace foldless
