// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/mesh/triangle.h"
#include "core/snapshot.h"

namespace foldless {

class Draft;

/// A handle as it is drawn.
struct HandleView {
  int id = 0;
  int vertex = 0;
  HandleKind kind = HandleKind::drag;
  std::string name;              ///< may be empty
  Vec2 position = Vec2::Zero();  ///< where it is
  Vec2 target = Vec2::Zero();    ///< where it should be
  double residual = 0;           ///< distance between the two [length]
  bool is_at_target = true;      ///< false: draw ring, line and distance
  bool is_selected = false;
  bool is_hovered = false;
};

/// The handles of the mesh on screen; none when nothing is open.
std::vector<HandleView> handle_views(const Draft& draft);

/// What lists call a handle: its name, or its vertex where it has none.
std::string handle_title(const std::string& name, int vertex);

}  // namespace foldless
