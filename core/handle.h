// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/mesh/triangle.h"

namespace foldless {

/// How a handle holds its vertex; told apart by shape on screen.
enum class HandleKind { drag, pin, soft };

/// The mesh round a handle turns with it: what is within the radius at rest follows rigidly.
struct Turn {
  double angle = 0;   ///< counter-clockwise from the rest shape, any number of turns [degrees]
  double radius = 0;  ///< [length]

  bool operator==(const Turn&) const = default;
};

/// The mesh round a handle is so many times as stiff, within a radius at rest.
struct StiffDisk {
  double factor = 1;  ///< on the energy, > 0
  double radius = 0;  ///< > 0 [length]

  bool operator==(const StiffDisk&) const = default;
};

/// A constrained vertex and where it should go, in input units.
struct Handle {
  int id = 0;                          ///< stable name, unique in a scene
  int vertex = 0;                      ///< index into the vertices of the mesh
  Vec2 target = Vec2::Zero();          ///< where the vertex should be
  HandleKind kind = HandleKind::drag;  ///< `soft` handles are weighted and need not be met
  double weight = 1;                   ///< factor on α, used for soft handles only
  double depth = 0;                    ///< the larger is in front where the mesh overlaps itself
  std::optional<Turn> turn = std::nullopt;        ///< absent: the mesh round it is free to turn
  std::string name = {};                          ///< what the user calls it; may be empty
  std::optional<StiffDisk> stiff = std::nullopt;  ///< absent: as stiff as without the handle

  bool operator==(const Handle&) const = default;
};

}  // namespace foldless
