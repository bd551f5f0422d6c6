// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/frames.h"

#include <utility>

#include "core/run/run.h"

namespace foldless {

Frames::Frames(Problem at_rest, Animation animation)
    : at_rest_(std::move(at_rest)), animation_(std::move(animation)) {
  if (!at_rest_.original)
    at_rest_.original = OriginalMesh{std::make_shared<const Triangles>(at_rest_.mesh.triangles()),
                                     at_rest_.mesh.vertex_count()};
}

Problem Frames::problem_at(double frame, const Snapshot* before) const {
  Problem problem = at_rest_;
  problem.handles = handles(frame);
  if (!before) return problem;
  problem.mesh = MeshPair(*before->triangles, *before->rest, before->deformed);
  problem.mesh.set_stiffness(at_rest_.mesh.stiffness());
  return problem;
}

std::optional<SolvedFrame> Frames::solve(double frame, const Snapshot* before,
                                         const std::stop_token& token, const Visit& visit) const {
  Run run(problem_at(frame, before));
  std::shared_ptr<const Snapshot> last = run.snapshot();
  while (!run.outcome()) {
    if (!run.step(token) && !run.outcome()) return std::nullopt;
    if (run.snapshot() == last) continue;
    last = run.snapshot();
    visit(last);
  }
  return SolvedFrame{frame, run.snapshot(), run.is_satisfied(), run.verdict()};
}

}  // namespace foldless
