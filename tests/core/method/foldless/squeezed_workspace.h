// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/generate.h"
#include "tests/core/method/foldless/workspaces.h"

namespace foldless::test {

/// A square that is `factor` times as wide as high.
inline OwnWorkspace squeezed_workspace(int cells, double factor) {
  const Shape shape = grid({.columns = cells, .rows = cells, .width = 1, .height = 1});
  Points u = shape.rest;
  u.row(1) /= factor;
  return workspace_of(MeshPair(shape.triangles, shape.rest, u),
                      {{.id = 0, .vertex = 0, .target = u.col(0)}});
}

}  // namespace foldless::test
