// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/picking.h"

#include <algorithm>
#include <limits>

namespace foldless {
namespace {

/// Barycentric coordinates of a point in a deformed triangle.
Eigen::Vector3d barycentric_in(const Snapshot& pose, int triangle, const Vec2& world) {
  const Eigen::Vector3i t = pose.triangles->col(triangle);
  const Vec2 a = pose.deformed.col(t[0]);
  const Vec2 b = pose.deformed.col(t[1]);
  const Vec2 c = pose.deformed.col(t[2]);
  const Eigen::Vector3d areas(signed_area(world, b, c), signed_area(a, world, c),
                              signed_area(a, b, world));
  return areas / areas.sum();
}

bool holds(const Points& points, const Eigen::Vector3i& triangle, const Vec2& world) {
  const Vec2 a = points.col(triangle[0]), b = points.col(triangle[1]), c = points.col(triangle[2]);
  return signed_area(a, b, world) >= 0 && signed_area(b, c, world) >= 0 &&
         signed_area(c, a, world) >= 0;
}

/// The first triangle from `first` on that holds a point.
std::optional<int> next_triangle_at(const Triangles& triangles, const Points& points,
                                    const Vec2& world, Eigen::Index first) {
  for (Eigen::Index t = first; t < triangles.cols(); ++t)
    if (holds(points, triangles.col(t), world)) return static_cast<int>(t);
  return std::nullopt;
}

/// Whether a ray from the point to the right crosses the closed line an odd number of times.
bool surrounds(const std::vector<Vec2>& line, const Vec2& p) {
  bool is_inside = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vec2 &a = line[i], &b = line[(i + 1) % line.size()];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    const double x = a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    if (x > p.x()) is_inside = !is_inside;
  }
  return is_inside;
}

template <class IsWanted>
std::vector<int> handles_where(const Snapshot* shown, const Canvas& canvas,
                               const IsWanted& is_wanted) {
  std::vector<int> ids;
  if (!shown) return ids;
  for (const Handle& handle : shown->handles)
    if (is_wanted(canvas.to_pixel(shown->deformed.col(handle.vertex)))) ids.push_back(handle.id);
  std::sort(ids.begin(), ids.end());
  return ids;
}

/// The nearest of some vertices within the hit radius of a pixel.
class NearestVertex {
 public:
  NearestVertex(const Snapshot& pose, const Canvas& canvas, const Vec2& pixel)
      : pose_(pose), canvas_(canvas), pixel_(pixel), distance_(canvas.hit_radius()) {}

  void offer(int vertex) {
    const double d = (canvas_.to_pixel(pose_.deformed.col(vertex)) - pixel_).norm();
    if (d > distance_) return;
    distance_ = d;
    vertex_ = vertex;
  }
  std::optional<int> result() const { return vertex_; }

 private:
  const Snapshot& pose_;
  const Canvas& canvas_;
  Vec2 pixel_;
  double distance_;
  std::optional<int> vertex_;
};

}  // namespace

std::optional<HandleHit> pick_handle(const Snapshot* shown, const Canvas& canvas,
                                     const Vec2& pixel) {
  std::optional<HandleHit> hit;
  if (!shown) return hit;
  double nearest = canvas.hit_radius();
  const auto offer = [&](const Vec2& world, HandleHit candidate) {
    const double d = (canvas.to_pixel(world) - pixel).norm();
    if (d > nearest || (hit && d == nearest)) return;
    nearest = d;
    hit = candidate;
  };
  for (const Handle& handle : shown->handles)
    offer(shown->deformed.col(handle.vertex), {handle.id, false});
  for (const Handle& handle : shown->handles) offer(handle.target, {handle.id, true});
  return hit;
}

std::vector<int> handles_in(const Snapshot* shown, const Canvas& canvas, const PixelBox& box) {
  return handles_where(shown, canvas, [&](const Vec2& pixel) { return box.contains(pixel); });
}

std::vector<int> handles_in_lasso(const Snapshot* shown, const Canvas& canvas,
                                  const std::vector<Vec2>& line) {
  return handles_where(shown, canvas, [&](const Vec2& pixel) { return surrounds(line, pixel); });
}

std::optional<int> triangle_at(const Snapshot& shown, const Vec2& world, PaintOrder& order) {
  const auto next = [&](Eigen::Index first) {
    return next_triangle_at(*shown.triangles, shown.deformed, world, first);
  };
  std::optional<int> front = next(0);
  const std::optional<int> second = front ? next(*front + 1) : std::nullopt;
  if (!second) return front;
  const std::vector<int>& layers = order.layers(shown, shown.deformed);
  const auto layer = [&](int t) { return layers[static_cast<std::size_t>(t)]; };
  for (std::optional<int> hit = second; hit; hit = next(*hit + 1))
    if (layer(*hit) > layer(*front)) front = hit;
  return front;
}

std::optional<int> triangle_at(const Triangles& triangles, const Points& points,
                               const Vec2& world) {
  return next_triangle_at(triangles, points, world, 0);
}

std::optional<MeshHit> pick_mesh(const Snapshot* shown, const Canvas& canvas, const Vec2& pixel,
                                 PaintOrder& order) {
  if (!shown) return std::nullopt;
  const Snapshot& pose = *shown;
  const Vec2 world = canvas.to_world(pixel);
  const std::optional<int> triangle = triangle_at(pose, world, order);
  MeshHit hit;
  NearestVertex nearest(pose, canvas, pixel);
  if (triangle) {
    hit.triangle = *triangle;
    hit.barycentric = barycentric_in(pose, *triangle, world);
    for (const int v : pose.triangles->col(*triangle)) nearest.offer(v);
  }
  // Where sheets of the mesh lie over each other, the corners of the triangle come first.
  if (!nearest.result())
    for (const int v : pose.triangles->reshaped()) nearest.offer(v);
  hit.vertex = nearest.result();
  if (!hit.vertex && !triangle) return std::nullopt;
  return hit;
}

}  // namespace foldless
