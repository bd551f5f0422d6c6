// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/stiffness.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace foldless {
namespace {

double squared_distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double length = along.squaredNorm();
  const double t = length > 0 ? std::clamp((p - a).dot(along) / length, 0.0, 1.0) : 0;
  return (a + t * along - p).squaredNorm();
}

bool covers(const StiffStroke& stroke, const Vec2& point) {
  const Points& line = stroke.line;
  const double reach = stroke.radius * stroke.radius;
  if ((line.col(0) - point).squaredNorm() <= reach) return true;
  for (Eigen::Index i = 1; i < line.cols(); ++i)
    if (squared_distance_to_segment(point, line.col(i - 1), line.col(i)) <= reach) return true;
  return false;
}

Eigen::AlignedBox2d box_of(const StiffStroke& stroke) {
  const Vec2 margin = Vec2::Constant(stroke.radius);
  return {stroke.line.rowwise().minCoeff() - margin, stroke.line.rowwise().maxCoeff() + margin};
}

std::vector<StiffStroke> scaled(std::vector<StiffStroke> strokes, double factor) {
  for (StiffStroke& stroke : strokes) {
    stroke.line *= factor;
    stroke.radius *= factor;
  }
  return strokes;
}

}  // namespace

bool StiffStroke::operator==(const StiffStroke& other) const {
  return radius == other.radius && factor == other.factor && line.cols() == other.line.cols() &&
         line == other.line;
}

Stiffness::Stiffness(std::vector<StiffStroke> strokes, std::vector<StiffStroke> disks)
    : strokes_(std::move(strokes)), disks_(std::move(disks)) {
  for (const StiffStroke& stroke : strokes_) {
    assert(stroke.line.cols() > 0 && stroke.radius > 0 && stroke.factor > 0);
    boxes_.push_back(box_of(stroke));
  }
}

double Stiffness::at(const Vec2& point) const {
  double factor = 1;
  for (std::size_t i = strokes_.size(); i-- > 0;) {
    if (!boxes_[i].contains(point) || !covers(strokes_[i], point)) continue;
    factor = strokes_[i].factor;
    break;
  }
  if (disks_.empty()) return factor;
  for (const StiffStroke& disk : disks_)
    if (covers(disk, point)) factor *= disk.factor;
  return std::clamp(factor, kLeastStiffness, kLargestStiffness);
}

Stiffness Stiffness::scaled(double factor) const {
  return Stiffness(foldless::scaled(strokes_, factor), foldless::scaled(disks_, factor));
}

std::shared_ptr<const Stiffness> stiffness_with(const std::shared_ptr<const Stiffness>& strokes,
                                                const std::vector<Handle>& handles,
                                                const Points& rest) {
  std::vector<StiffStroke> disks;
  for (const Handle& handle : handles)
    if (handle.stiff)
      disks.push_back({rest.col(handle.vertex), handle.stiff->radius, handle.stiff->factor});
  if (disks.empty()) return strokes;
  return std::make_shared<const Stiffness>(
      strokes ? strokes->strokes() : std::vector<StiffStroke>{}, std::move(disks));
}

}  // namespace foldless
