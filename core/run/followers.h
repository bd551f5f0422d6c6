// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/handle.h"
#include "core/mesh/triangle.h"

namespace foldless {

/// The vertices round handles that turn. A method knows handles only, so each of them is one: it
/// keeps the place that it has at rest as seen from its leader, turned by the leader's angle, and
/// is met or not as the leader is. A vertex that is a handle itself follows nobody; one that is
/// near several follows the nearest.
class Followers {
 public:
  /// `original`: the triangles before any remeshing, 3 × #F, of the first vertices of `rest`,
  /// 2 × #V. Vertices of splits do not follow: they go where their neighbours take them. What is
  /// within the radius but cannot be reached there along edges belongs to another limb and stays.
  Followers(const Triangles& original, const Points& rest, const std::vector<Handle>& handles);

  /// The handles, then one for each follower. Precondition: the same handles as in the
  /// constructor but for targets and angles.
  std::vector<Handle> with_followers(const std::vector<Handle>& handles) const;

 private:
  struct Follower {
    int vertex = 0;
    std::size_t leader = 0;      ///< index of its handle
    Vec2 offset = Vec2::Zero();  ///< from the leader at rest [length]
  };
  std::vector<Follower> followers_;
};

}  // namespace foldless
