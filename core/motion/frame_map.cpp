// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/frame_map.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "core/mesh/orientation.h"

namespace foldless {
namespace {

using Corners = Eigen::Matrix<double, 2, 3>;

/// All of b is on the right of a side of a, or on it.
bool is_parted_by_a_side(const Corners& a, const Corners& b) {
  for (int side = 0; side < 3; ++side) {
    const Vec2 from = a.col(side), to = a.col((side + 1) % 3);
    bool is_parted = true;
    for (int corner = 0; corner < 3 && is_parted; ++corner)
      is_parted = orientation(from, to, b.col(corner)) <= 0;
    if (is_parted) return true;
  }
  return false;
}

}  // namespace

bool share_area(const Corners& a, const Corners& b) {
  return !is_parted_by_a_side(a, b) && !is_parted_by_a_side(b, a);
}

Eigen::Vector3d barycentric(const Corners& corners, const Vec2& point) {
  const Vec2 a = corners.col(0), b = corners.col(1), c = corners.col(2);
  const Eigen::Vector3d areas(signed_area(b, c, point), signed_area(c, a, point),
                              signed_area(a, b, point));
  return areas / areas.sum();
}

FrameMap::FrameMap(std::shared_ptr<const Snapshot> snapshot, const Triangles& original)
    : snapshot_(std::move(snapshot)), original_(original) {
  const Triangles& triangles = *snapshot_->triangles;
  first_.assign(static_cast<std::size_t>(snapshot_->rest->cols()) + 1, 0);
  for (const int v : triangles.reshaped()) ++first_[static_cast<std::size_t>(v) + 1];
  for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
  std::vector<int> next(first_.begin(), first_.end() - 1);
  round_.resize(static_cast<std::size_t>(triangles.size()));
  for (Eigen::Index t = 0; t < triangles.cols(); ++t)
    for (const int v : triangles.col(t))
      round_[static_cast<std::size_t>(next[static_cast<std::size_t>(v)]++)] = static_cast<int>(t);
}

std::vector<int> FrameMap::neighbours(int triangle) const {
  const Triangles& triangles = *snapshot_->triangles;
  const Eigen::Vector3i corners = triangles.col(triangle);
  std::vector<int> result;
  for (const int v : corners)
    for (int k = first_[static_cast<std::size_t>(v)]; k < first_[static_cast<std::size_t>(v) + 1];
         ++k) {
      const int other = round_[static_cast<std::size_t>(k)];
      int common = 0;
      for (const int w : triangles.col(other)) common += (corners.array() == w).any() ? 1 : 0;
      if (common == 2) result.push_back(other);
    }
  return result;
}

std::vector<int> FrameMap::find_covering(int triangle) const {
  const Points& rest = *snapshot_->rest;
  const Eigen::Vector3i corners = original_.col(triangle);
  const Corners covered = corners_of(rest, corners);
  const auto covers = [&](int t) {
    return share_area(corners_of(rest, snapshot_->triangles->col(t)), covered);
  };
  std::vector<int> found;
  std::set<int> seen;
  const auto visit = [&](int t) {
    if (seen.insert(t).second && covers(t)) found.push_back(t);
  };
  const auto corner = static_cast<std::size_t>(corners[0]);
  for (int k = first_[corner]; k < first_[corner + 1]; ++k)
    visit(round_[static_cast<std::size_t>(k)]);
  for (std::size_t i = 0; i < found.size(); ++i)
    for (const int t : neighbours(found[i])) visit(t);
  return found;
}

const std::vector<int>& FrameMap::covering(int triangle) const {
  const auto [place, is_new] = covering_.try_emplace(triangle);
  if (is_new) place->second = find_covering(triangle);
  return place->second;
}

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
