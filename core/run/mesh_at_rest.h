// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/handle.h"
#include "core/mesh/mesh_pair.h"
#include "core/mesh/shape.h"

namespace foldless {

/// An undeformed mesh with handles on it.
struct MeshAtRest {
  MeshPair mesh;                ///< without stiffness
  std::vector<Handle> handles;  ///< each at its vertex; targets as they were
};

/// The undeformed mesh that a drawing began with, and a vertex where a handle is not at one of its
/// own: it depends on nothing but the shape and where the handles are at rest, and not on what was
/// remeshed since. `rest` has the vertices that the handles name, the shape's own first. Of two
/// handles that come to one vertex the second is left out.
MeshAtRest mesh_at_rest(const Shape& shape, const std::vector<Handle>& handles, const Points& rest,
                        double delta);

}  // namespace foldless
