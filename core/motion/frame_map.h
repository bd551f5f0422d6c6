// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "core/mesh/triangle.h"
#include "core/motion/corners.h"
#include "core/motion/rest_cover.h"
#include "core/snapshot.h"

namespace foldless {

/// The map of a solved frame over the triangles of the original mesh, whatever flips and splits the
/// frame's own triangulation has seen: it has all original vertices, where they were at rest. What
/// lies in an original triangle is found along edges, so that a rest mesh may lie over itself.
class FrameMap {
 public:
  /// `original`: 3 × #F.
  FrameMap(std::shared_ptr<const Snapshot> snapshot, const Triangles& original);
  /// `cover` is of the snapshot's mesh.
  FrameMap(std::shared_ptr<const Snapshot> snapshot, std::shared_ptr<const RestCover> cover);

  const Snapshot& snapshot() const { return *snapshot_; }
  /// The frame's triangles that share area at rest with an original one.
  std::span<const int> covering(int triangle) const { return cover_->covering(triangle); }
  /// Where the frame takes a point of an original triangle at rest.
  Vec2 at(const Vec2& rest, int triangle) const;

 private:
  std::shared_ptr<const Snapshot> snapshot_;
  std::shared_ptr<const RestCover> cover_;
};

}  // namespace foldless
