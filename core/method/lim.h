// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/method/stepped_method.h"
#include "core/solve/damped_system.h"

namespace foldless {

/// Locally injective mappings [SKPSH13], one vertex update a step: damped Newton steps on E of
/// eq. 5, the whole mesh, no remeshing. When the Hessian had to be shifted by μ, the targets of the
/// step are t p + (1 − t) C u with t = 1/(1 + μ²): sub-stepping.
///
/// Triangles are tested where a step ends and not on the way: they stay positive, but a step may
/// jump so far that they cover the surroundings of an interior vertex twice, which verdict()
/// says. Lengths are in units of D, the diagonal of the rest mesh, whatever that is.
class Lim final : public SteppedMethod {
 public:
  explicit Lim(const Problem& problem);

  std::string verdict() const override { return verdict_; }
  const MeshPair& mesh() const override { return mesh_; }
  void set_targets(const Points& targets) override;

 private:
  Steps<Outcome> solve();
  VertexUpdate update(double& step_scale, const std::stop_token& token);
  VertexUpdate move_along(const Points& step, const Energy& energy, double& step_scale);
  std::optional<Outcome> convergence(const VertexUpdate& update) const;

  MeshPair mesh_;
  Parameters parameters_;
  double diagonal_;  ///< D
  Energy energy_;
  DampedSystem system_;
  std::string verdict_;
};

}  // namespace foldless
