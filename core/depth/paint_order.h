// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/depth/depth_field.h"
#include "core/depth/paint_group.h"
#include "core/depth/paint_layers.h"
#include "core/mesh/parts.h"
#include "core/snapshot.h"

namespace foldless {

/// In which order the triangles of one snapshot after another are painted, so that sheets that lie
/// over each other stay whole: the one whose handles have the greater depth is in front; where no
/// handle has one or depths are equal, the component that comes later, then what is farther out of
/// its component at rest and to the right. Keeps what the next snapshot needs again: while nothing
/// overlaps it only looks at the boundary.
class PaintOrder {
 public:
  /// The depths of parts are those of their triangles, from now on, to which those of handles are
  /// added; null: all 0.
  void set_parts(std::shared_ptr<const MeshParts> parts);

  /// A layer for every triangle, see paint_layers(), as `points` have them: the snapshot's rest or
  /// deformed positions. Parts of other depths have layers of their own; but for that all are 0
  /// where nothing overlaps, and where the map folds: then there are no sheets. Valid until the
  /// next call. Precondition: the snapshot has triangles and a rest mesh.
  const std::vector<int>& layers(const Snapshot& snapshot, const Points& points);

 private:
  void adopt(const Snapshot& snapshot);
  /// Returns whether they are others.
  bool adopt_depths(const Snapshot& snapshot);
  void refresh_keys(const Snapshot& snapshot);

  std::shared_ptr<const MeshParts> parts_;
  std::optional<std::uint64_t> revision_;
  std::vector<HandleDepth> depths_;  ///< empty: no handle has one
  std::vector<PaintGroup> groups_;   ///< of that revision, parts and depths; empty: none yet
  DepthField depth_;
  PaintKeys keys_;  ///< made when something overlaps
  bool has_keys_ = false, has_order_ = false;
  bool is_known_ = false;  ///< what follows, for points_
  Points points_;
  std::vector<int> layers_;
};

}  // namespace foldless
