// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <stop_token>

#include "core/method/foldless/workspace.h"
#include "core/method/method.h"
#include "core/remesh/coarsen.h"

namespace foldless {

/// Coarse-to-fine, the paper's future work: the problem is solved on a mesh of fewer vertices
/// first, and the fine mesh begins with the map of that one. A coarse mesh that is dense itself
/// begins so too.
class Coarse {
 public:
  /// Nothing where the mesh is not dense, or where few of its vertices may go.
  static std::optional<Coarse> of(const Problem& problem);

  Coarse(const Coarse& other);
  Coarse& operator=(const Coarse& other);
  Coarse(Coarse&&) noexcept = default;
  Coarse& operator=(Coarse&&) noexcept = default;

  /// One step of the coarse run, whose record `iteration` is; its counters and times are the
  /// workspace's too. Arrives when that run has its handles on their targets and the workspace has
  /// taken its map over. Locks when it ended otherwise, or when the fine mesh would fold; the fine
  /// mesh is then as it was.
  Progress step(Workspace& workspace, std::stop_token token, Iteration& iteration);

 private:
  Coarse(CoarseMesh coarse, Problem problem);

  CoarseMesh coarse_;
  std::unique_ptr<Method> run_;
};

}  // namespace foldless
