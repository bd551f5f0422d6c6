// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "app/editor/canvas.h"
#include "core/depth/paint_order.h"
#include "core/snapshot.h"

namespace foldless {

/// A handle under the pointer: the dot itself, or the ring at its target.
struct HandleHit {
  int id = 0;
  bool is_target = false;
};

// What is picked from is the snapshot on screen; null when nothing is open.

/// The handle or target ring nearest to a pixel within the hit radius; the dot wins a tie.
std::optional<HandleHit> pick_handle(const Snapshot* shown, const Canvas& canvas,
                                     const Vec2& pixel);

/// Handles whose dot is inside a rectangle, by id.
std::vector<int> handles_in(const Snapshot* shown, const Canvas& canvas, const PixelBox& box);
/// Handles whose dot is inside a closed line of pixels, by the even-odd rule, by id.
std::vector<int> handles_in_lasso(const Snapshot* shown, const Canvas& canvas,
                                  const std::vector<Vec2>& line);

/// The triangle of the deformed mesh that holds a world point, or nothing; where sheets lie over
/// each other the one in front.
/// `order` keeps what the next call needs again.
std::optional<int> triangle_at(const Snapshot& shown, const Vec2& world, PaintOrder& order);

/// The triangle that holds a point; `points` are 2 × #V.
std::optional<int> triangle_at(const Triangles& triangles, const Points& points, const Vec2& world);

/// A place on the deformed mesh where a handle can go: a vertex, or else a point of a triangle.
struct MeshHit {
  std::optional<int> vertex;                              ///< within the hit radius
  int triangle = -1;                                      ///< valid when there is no vertex
  Eigen::Vector3d barycentric = Eigen::Vector3d::Zero();  ///< of the point in that triangle
};

/// Where on the mesh a pixel is: a corner of the triangle under it that is within the hit radius
/// before any other vertex there, before the point in the triangle itself.
std::optional<MeshHit> pick_mesh(const Snapshot* shown, const Canvas& canvas, const Vec2& pixel,
                                 PaintOrder& order);

}  // namespace foldless
