// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/stiffness_brush.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "app/editor/picking.h"

namespace foldless {
namespace {

/// The pointer has left a limb for another one when it goes so much farther at rest than on screen.
constexpr double kLeap = 4;

/// Where a point of a deformed triangle is at rest.
Vec2 at_rest(const Snapshot& shown, int triangle, const Vec2& point) {
  const Eigen::Vector3i t = shown.triangles->col(triangle);
  const Mat2 back = deformation_gradient(shown.deformed, *shown.rest, t);
  return shown.rest->col(t[0]) + back * (point - shown.deformed.col(t[0]));
}

void append(const Vec2& point, Points& line) {
  line.conservativeResize(2, line.cols() + 1);
  line.rightCols<1>() = point;
}

}  // namespace

void StiffnessBrush::set_factor(double factor) {
  if (std::isfinite(factor)) factor_ = std::clamp(factor, kLeastFactor, kLargestFactor);
}

void StiffnessBrush::set_radius(double design_pixels) {
  if (std::isfinite(design_pixels))
    radius_ = std::clamp(design_pixels, kLeastRadius, kLargestRadius);
}

std::optional<Vec2> StiffnessBrush::rest_place(const Canvas& canvas, const Vec2& pixel) {
  const std::shared_ptr<const Snapshot>& shown = draft_.shown();
  if (!shown) return std::nullopt;
  const Vec2 point = canvas.to_world(pixel);
  const auto triangle = triangle_at(*shown, point, draft_.paint_order());
  if (!triangle) return std::nullopt;
  return at_rest(*shown, *triangle, point);
}

void StiffnessBrush::press(const Canvas& canvas, const Vec2& pixel, bool takes_back) {
  painted_.clear();
  last_ = {pixel, std::nullopt};
  next_ = {Points(2, 0), radius_ * canvas.ui_scale / canvas.camera.pixels_per_unit,
           takes_back ? 1 : factor_};
  move(canvas, pixel);
}

void StiffnessBrush::move(const Canvas& canvas, const Vec2& pixel) {
  const Place place{pixel, rest_place(canvas, pixel)};
  const Place before = std::exchange(last_, place);
  if (!place.at_rest) return;
  const double way = (place.pixel - before.pixel).norm() / canvas.camera.pixels_per_unit;
  const bool goes_on =
      before.at_rest && (*place.at_rest - *before.at_rest).norm() <= kLeap * (way + next_.radius);
  if (!goes_on || painted_.empty()) painted_.push_back(next_);
  append(*place.at_rest, painted_.back().line);
}

void StiffnessBrush::release() {
  if (painted_.empty()) return;
  edit(next_.factor == 1 ? "Unpaint stiffness" : "Paint stiffness", strokes());
  painted_.clear();
}

void StiffnessBrush::clear() {
  draft_.interrupt();
  if (can_clear()) edit("Remove stiffness", {});
}

bool StiffnessBrush::is_tinted() const {
  if (is_on_) return true;
  return std::ranges::any_of(draft_.document().handles, [this](const Handle& handle) {
    return handle.stiff && draft_.selection().ids().contains(handle.id);
  });
}

std::vector<StiffStroke> StiffnessBrush::strokes() const {
  std::vector<StiffStroke> all;
  if (const auto& stiffness = draft_.document().stiffness) all = stiffness->strokes();
  all.insert(all.end(), painted_.begin(), painted_.end());
  return all;
}

void StiffnessBrush::edit(const std::string& label, std::vector<StiffStroke> strokes) {
  Document document = draft_.document();
  document.stiffness.reset();
  if (!strokes.empty()) document.stiffness = std::make_shared<const Stiffness>(std::move(strokes));
  draft_.edit(label, std::move(document), Change::mesh);
}

const std::vector<float>& StiffnessBrush::factors() {
  const std::shared_ptr<const Snapshot>& shown = draft_.shown();
  Seen now{draft_.document().stiffness, {}, {}, shown ? shown->revision : 0, 0};
  for (const Handle& handle : draft_.document().handles) {
    if (!handle.stiff) continue;
    now.disks.push_back(*handle.stiff);
    now.vertices.push_back(handle.vertex);
  }
  for (const StiffStroke& stroke : painted_) now.points += stroke.line.cols();
  if (now == seen_) return factors_;
  seen_ = std::move(now);
  factors_.clear();
  if (!shown) return factors_;
  const auto painted = std::make_shared<const Stiffness>(strokes());
  const auto stiffness = stiffness_with(painted, draft_.document().handles, *shown->rest);
  if (stiffness == painted && painted->strokes().empty()) return factors_;
  factors_.reserve(static_cast<std::size_t>(shown->triangles->cols()));
  for (const auto& t : shown->triangles->colwise()) {
    const Vec2 sum = shown->rest->col(t[0]) + shown->rest->col(t[1]) + shown->rest->col(t[2]);
    factors_.push_back(static_cast<float>(stiffness->at(sum / 3)));
  }
  return factors_;
}

}  // namespace foldless
