// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>

#include "core/mesh/triangle.h"

namespace foldless {

/// Makes of a mesh without vertices what add_vertex() and, triangle by triangle, OpenMesh's
/// add_face() would, handle by handle, in less time. Precondition: oriented manifold triangles with
/// indices in [0, vertex_count).
void connect(OpenMesh::TriConnectivity& mesh, const Triangles& triangles, int vertex_count);

}  // namespace foldless
