// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/frame_map.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace foldless {
FrameMap::FrameMap(std::shared_ptr<const Snapshot> snapshot, std::shared_ptr<const RestCover> cover)
    : snapshot_(std::move(snapshot)), cover_(std::move(cover)) {}

FrameMap::FrameMap(std::shared_ptr<const Snapshot> snapshot, const Triangles& original)
    : snapshot_(std::move(snapshot)),
      cover_(std::make_shared<const RestCover>(*snapshot_, original)) {}

Vec2 FrameMap::at(const Vec2& rest, int triangle) const {
  double depth = -std::numeric_limits<double>::infinity();
  Vec2 place = rest;
  for (const int t : covering(triangle)) {
    const Eigen::Vector3i corners = snapshot_->triangles->col(t);
    const Eigen::Vector3d weights = barycentric(corners_of(*snapshot_->rest, corners), rest);
    if (weights.minCoeff() <= depth) continue;
    depth = weights.minCoeff();
    place = corners_of(snapshot_->deformed, corners) * weights;
  }
  return place;
}

}  // namespace foldless
