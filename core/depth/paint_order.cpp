// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/depth/paint_order.h"

#include <algorithm>

#include "core/depth/depth_field.h"
#include "core/mesh/components.h"

namespace foldless {
namespace {

/// How much the direction to the right counts beside the distance from the middle: two arms that
/// are alike are told apart by it.
constexpr double kToTheRight = 0.25;
/// More than two triangles of one component can differ.
constexpr double kComponent = 4;

/// The same value for every triangle as the mean of its corners.
Eigen::VectorXd by_triangle(const Triangles& triangles, const Eigen::VectorXd& by_vertex) {
  Eigen::VectorXd means(triangles.cols());
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) means[t] = by_vertex(triangles.col(t)).mean();
  return means;
}

/// For every component, named by components_of(), its place among them and its middle at rest.
struct Middle {
  double rank = -1;
  Vec2 centre = Vec2::Zero();
  double count = 0, radius = 0;
};

/// What is in front where depths say nothing: limbs lie in front of the body, and of two limbs the
/// right one; that does not change while they are dragged, as it depends on the rest mesh alone.
Eigen::VectorXd order_at_rest(const Triangles& triangles, const Points& rest) {
  const std::vector<int> component = components_of(triangles, static_cast<int>(rest.cols()));
  std::vector<Middle> middles(component.size());
  const auto middle_of = [&](Eigen::Index v) -> Middle& {
    return middles[static_cast<std::size_t>(component[static_cast<std::size_t>(v)])];
  };
  double components = 0;
  for (Eigen::Index v = 0; v < rest.cols(); ++v) {
    Middle& middle = middle_of(v);
    if (middle.rank < 0) middle.rank = components++;
    middle.centre += (rest.col(v) - middle.centre) / ++middle.count;
  }
  for (Eigen::Index v = 0; v < rest.cols(); ++v) {
    Middle& middle = middle_of(v);
    middle.radius = std::max(middle.radius, (rest.col(v) - middle.centre).norm());
  }
  Eigen::VectorXd order(rest.cols());
  for (Eigen::Index v = 0; v < rest.cols(); ++v) {
    const Middle& middle = middle_of(v);
    const Vec2 away = rest.col(v) - middle.centre;
    const double place = away.norm() + kToTheRight * away.x();
    order[v] = kComponent * middle.rank + (middle.radius > 0 ? place / middle.radius : 0);
  }
  return order;
}

}  // namespace

void PaintOrder::set_parts(std::shared_ptr<const MeshParts> parts) {
  if (parts == parts_) return;
  parts_ = std::move(parts);
  revision_.reset();
}

void PaintOrder::adopt(const Snapshot& snapshot) {
  if (revision_ == snapshot.revision) return;
  revision_ = snapshot.revision;
  groups_.clear();
  has_keys_ = has_order_ = is_known_ = false;
}

bool PaintOrder::adopt_depths(const Snapshot& snapshot) {
  std::vector<HandleDepth> depths;
  if (has_depths(snapshot.handles))
    for (const Handle& handle : snapshot.handles) depths.emplace_back(handle.vertex, handle.depth);
  if (depths == depths_) return false;
  depths_ = std::move(depths);
  has_keys_ = false;
  if (parts_) groups_.clear();
  return true;
}

void PaintOrder::refresh_keys(const Snapshot& snapshot) {
  if (has_keys_) return;
  has_keys_ = true;
  const Triangles& triangles = *snapshot.triangles;
  keys_.depth = by_triangle(triangles, depth_.update(triangles, *snapshot.rest, snapshot.handles));
  if (parts_) {
    const std::vector<int> part =
        parts_of_triangles(triangles, static_cast<int>(snapshot.rest->cols()), *parts_);
    for (Eigen::Index t = 0; t < triangles.cols(); ++t)
      keys_.depth[t] +=
          (*parts_)[static_cast<std::size_t>(part[static_cast<std::size_t>(t)])].depth;
  }
  if (!has_order_) keys_.order = by_triangle(triangles, order_at_rest(triangles, *snapshot.rest));
  has_order_ = true;
}

const std::vector<int>& PaintOrder::layers(const Snapshot& snapshot, const Points& points) {
  adopt(snapshot);
  const bool has_other_depths = adopt_depths(snapshot);
  const bool has_moved = !is_known_ || points_.cols() != points.cols() || points_ != points;
  if (!has_moved && !has_other_depths) return layers_;
  const bool is_new = groups_.empty();
  if (is_new)
    groups_ = paint_groups(snapshot.triangles, static_cast<int>(snapshot.rest->cols()),
                           parts_ ? *parts_ : MeshParts{}, depths_);
  points_ = points;
  is_known_ = true;
  layers_.assign(static_cast<std::size_t>(snapshot.triangles->cols()), 0);
  int next = 0;
  for (PaintGroup& group : groups_) {
    if (!snapshot.is_valid())
      group.clear_overlaps();
    else if (has_moved || is_new)
      group.find_overlaps(points);
    if (group.has_overlaps()) refresh_keys(snapshot);
    next =
        group.has_overlaps() ? group.paint(keys_, next, layers_) : group.paint_flat(next, layers_);
  }
  return layers_;
}

}  // namespace foldless
