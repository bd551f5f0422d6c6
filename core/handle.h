// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/triangle.h"

namespace foldless {

/// How a handle holds its vertex; told apart by shape on screen.
enum class HandleKind { drag, pin, soft };

/// A constrained vertex and where it should go, in input units.
struct Handle {
  int id = 0;                          ///< stable name, unique in a scene
  int vertex = 0;                      ///< index into the vertices of the mesh
  Vec2 target = Vec2::Zero();          ///< where the vertex should be
  HandleKind kind = HandleKind::drag;  ///< `soft` handles are weighted and need not be met
  double weight = 1;                   ///< factor on α, used for soft handles only
  double depth = 0;                    ///< the larger is in front where the mesh overlaps itself

  bool operator==(const Handle&) const = default;
};

}  // namespace foldless
