// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/api/point_map.h"

#include <algorithm>
#include <limits>
#include <sstream>
#include <string>
#include <utility>

#include "core/error.h"
#include "core/mesh/orientation.h"
#include "core/method/satisfied.h"
#include "core/motion/frame_map.h"

namespace foldless {
namespace {

using Triangle = Eigen::Matrix<double, 2, 3>;

constexpr double kLeastCoordinate = -1e-9;

std::vector<Eigen::AlignedBox2d> boxes_of(const Triangles& triangles, const Points& points) {
  std::vector<Eigen::AlignedBox2d> boxes;
  boxes.reserve(static_cast<std::size_t>(triangles.cols()));
  for (const auto& t : triangles.colwise()) {
    const Triangle corners = corners_of(points, t);
    boxes.emplace_back(Vec2(corners.rowwise().minCoeff()), Vec2(corners.rowwise().maxCoeff()));
  }
  return boxes;
}

bool holds(const Triangle& corners, const Vec2& p) {
  return orientation(corners.col(0), corners.col(1), p) >= 0 &&
         orientation(corners.col(1), corners.col(2), p) >= 0 &&
         orientation(corners.col(2), corners.col(0), p) >= 0;
}

/// How far p is inside, negative outside. [length]
double depth_in(const Triangle& corners, const Vec2& p) {
  double least = std::numeric_limits<double>::infinity();
  for (int side = 0; side < 3; ++side) {
    const Vec2 a = corners.col(side), b = corners.col((side + 1) % 3);
    least = std::min(least, 2 * signed_area(a, b, p) / (b - a).norm());
  }
  return least;
}

/// A corner that the point is, bit for bit.
std::optional<int> corner_at(const Eigen::Vector3i& triangle, const Points& rest, const Vec2& p) {
  for (const int v : triangle)
    if (rest.col(v) == p) return v;
  return std::nullopt;
}

void check_coordinates(Eigen::Index row, int triangle, Eigen::Index triangles,
                       const Eigen::Vector3d& coordinates) {
  const std::string name = "point " + std::to_string(row);
  if (triangle < 0 || triangle >= triangles)
    throw Error(name + " is in the triangle " + std::to_string(triangle) +
                ", but the triangles are 0 to " + std::to_string(triangles - 1));
  if (!(coordinates.minCoeff() >= kLeastCoordinate) ||
      !(std::abs(coordinates.sum() - 1) <= -kLeastCoordinate))
    throw Error(name + " lies outside of its triangle; barycentric coordinates are 0 or more and " +
                "add up to 1");
}

}  // namespace

PointMap::PointMap(Triangles input, std::shared_ptr<const Snapshot> snapshot)
    : input_(std::move(input)),
      snapshot_(std::move(snapshot)),
      tolerance_(1e-12 *
                 bounding_box_diagonal(snapshot_->rest->leftCols(snapshot_->original_vertices))),
      boxes_(boxes_of(input_, *snapshot_->rest)),
      grid_(boxes_) {}

int PointMap::triangle_at(const Vec2& point) const {
  int found = -1, nearest = -1;
  double depth = -tolerance_;
  const Vec2 margin = Vec2::Constant(tolerance_);
  grid_.for_each_near({Vec2(point - margin), Vec2(point + margin)}, [&](int t) {
    if (found >= 0 && found <= t) return;
    const Triangle corners = corners_of(*snapshot_->rest, input_.col(t));
    if (holds(corners, point)) {
      found = t;
    } else if (const double here = depth_in(corners, point); here >= depth) {
      depth = here;
      nearest = t;
    }
  });
  return found >= 0 ? found : nearest;
}

Points PointMap::at(const Points& points) const {
  const FrameMap map(snapshot_, input_);
  Points places(2, points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Vec2 point = points.col(i);
    const int triangle = triangle_at(point);
    if (triangle < 0) {
      std::ostringstream words;
      words << "point " << i << " at (" << point.x() << ", " << point.y()
            << ") lies outside of the mesh; only points of the mesh are mapped";
      throw Error(words.str());
    }
    const auto corner = corner_at(input_.col(triangle), *snapshot_->rest, point);
    places.col(i) = corner ? Vec2(snapshot_->deformed.col(*corner)) : map.at(point, triangle);
  }
  return places;
}

Points PointMap::at(const Eigen::VectorXi& triangles, const Eigen::Matrix3Xd& coordinates) const {
  if (triangles.size() != coordinates.cols())
    throw Error("there are " + std::to_string(triangles.size()) + " triangles for " +
                std::to_string(coordinates.cols()) + " rows of coordinates; give one for each");
  const FrameMap map(snapshot_, input_);
  Points places(2, coordinates.cols());
  for (Eigen::Index i = 0; i < coordinates.cols(); ++i) {
    check_coordinates(i, triangles[i], input_.cols(), coordinates.col(i));
    const Eigen::Vector3i corners = input_.col(triangles[i]);
    const Vec2 point = corners_of(*snapshot_->rest, corners) * coordinates.col(i);
    const auto corner = corner_at(corners, *snapshot_->rest, point);
    places.col(i) = corner ? Vec2(snapshot_->deformed.col(*corner)) : map.at(point, triangles[i]);
  }
  return places;
}

}  // namespace foldless
