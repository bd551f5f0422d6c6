// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/generate.h"
#include "core/method/foldless/cut_to_handles.h"
#include "core/method/foldless/tidy.h"
#include "tests/core/method/foldless/stage_runner.h"
#include "tests/core/method/foldless/workspaces.h"

namespace foldless::test {

/// Brings the handles inside of a held boundary to their targets, in a class of maps with distorted
/// and crushed triangles, and tidies. False where that fails.
inline bool arrive_distorted(Workspace& work) {
  constexpr int kSlits = 2;
  if (run_to_the_end(cut_to_handles(work, CutBoundary::held, kSlits)) != Progress::arrived)
    return false;
  run_to_the_end(tidy(work));
  return true;
}

/// A square that is `factor` times as wide as high.
inline OwnWorkspace squeezed_workspace(int cells, double factor) {
  const Shape shape = grid({.columns = cells, .rows = cells, .width = 1, .height = 1});
  Points u = shape.rest;
  u.row(1) /= factor;
  return workspace_of(MeshPair(shape.triangles, shape.rest, u),
                      {{.id = 0, .vertex = 0, .target = u.col(0)}});
}

}  // namespace foldless::test
