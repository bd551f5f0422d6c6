// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/injective.h"
#include "core/mesh/mesh_pair.h"

namespace foldless::test {

/// Rest and deformed mesh are proved locally injective, exactly.
inline bool is_valid(const MeshPair& mesh) {
  return is_injective(mesh.triangles(), mesh.rest(), mesh.deformed());
}

}  // namespace foldless::test
