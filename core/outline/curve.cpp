// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outline/curve.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>

namespace foldless {
namespace {

using std::numbers::pi;

constexpr int kStepsPerPiece = 48;  // fine enough that resampling sees a smooth curve

Vec2 rotated(const Vec2& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

/// How far along its edges the arc at a corner begins, and how much the corner turns.
struct Fillet {
  double reach = 0;
  double turn = 0;
};

Fillet fillet(const Vec2& before, const ControlPoint& corner, const Vec2& after) {
  const Vec2 in = (corner.position - before).normalized();
  const Vec2 out = (after - corner.position).normalized();
  const double turn = std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
  return {corner.radius * std::tan(0.5 * std::abs(turn)), turn};
}

void append_arc(const ControlPoint& corner, const Vec2& before, const Fillet& f, Loop& points) {
  const Vec2 in = (corner.position - before).normalized();
  const Vec2 start = corner.position - f.reach * in;
  const double radius = f.reach / std::tan(0.5 * std::abs(f.turn));
  const Vec2 normal = (f.turn > 0 ? 1 : -1) * Vec2(-in.y(), in.x());
  const Vec2 centre = start + radius * normal;
  for (int k = 0; k <= kStepsPerPiece; ++k)
    points.push_back(centre + rotated(start - centre, f.turn * k / kStepsPerPiece));
}

/// One piece of a Catmull-Rom curve from p[1] to p[2], its end left out (Barry and Goldman's
/// pyramid with centripetal knots).
void append_piece(const std::array<Vec2, 4>& p, Loop& points) {
  std::array<double, 4> knot{};
  for (int i = 1; i < 4; ++i)
    knot[i] = knot[i - 1] + std::max(std::sqrt((p[i] - p[i - 1]).norm()), 1e-9);
  const auto mix = [&](const Vec2& a, const Vec2& b, int i, int j, double t) -> Vec2 {
    return (knot[j] - t) / (knot[j] - knot[i]) * a + (t - knot[i]) / (knot[j] - knot[i]) * b;
  };
  for (int k = 0; k < kStepsPerPiece; ++k) {
    const double t = knot[1] + (knot[2] - knot[1]) * k / kStepsPerPiece;
    const Vec2 a = mix(p[0], p[1], 0, 1, t), b = mix(p[1], p[2], 1, 2, t);
    const Vec2 c = mix(p[2], p[3], 2, 3, t);
    points.push_back(mix(mix(a, b, 0, 2, t), mix(b, c, 1, 3, t), 1, 2, t));
  }
}

std::vector<double> arc_lengths(const Loop& points) {
  std::vector<double> lengths{0};
  for (std::size_t i = 0; i < points.size(); ++i)
    lengths.push_back(lengths.back() + (points[(i + 1) % points.size()] - points[i]).norm());
  return lengths;
}

/// The point of the closed polygon at an arc length in [0, total].
Vec2 point_at(const Loop& points, const std::vector<double>& lengths, double s) {
  const auto next = std::upper_bound(lengths.begin() + 1, lengths.end() - 1, s);
  const auto i = static_cast<std::size_t>(next - lengths.begin()) - 1;
  const double length = lengths[i + 1] - lengths[i];
  const double t = length > 0 ? std::clamp((s - lengths[i]) / length, 0.0, 1.0) : 0;
  return (1 - t) * points[i] + t * points[(i + 1) % points.size()];
}

/// Shares `count` segments out to stretches in proportion to their lengths, at least one each:
/// one after another to the stretch whose segments are longest (Webster's method).
std::vector<int> share_out(const std::vector<double>& stretches, int count) {
  std::vector<int> shares(stretches.size(), 1);
  for (int left = count - static_cast<int>(shares.size()); left > 0; --left) {
    std::size_t longest = 0;
    for (std::size_t i = 1; i < stretches.size(); ++i)
      if (stretches[i] / (shares[i] + 0.5) > stretches[longest] / (shares[longest] + 0.5))
        longest = i;
    ++shares[longest];
  }
  return shares;
}

}  // namespace

Curve rounded_polygon(const std::vector<ControlPoint>& points) {
  assert(points.size() >= 3);
  const std::size_t n = points.size();
  std::vector<Fillet> fillets;
  for (std::size_t i = 0; i < n; ++i)
    fillets.push_back(
        fillet(points[(i + n - 1) % n].position, points[i], points[(i + 1) % n].position));
  std::vector<double> room(n, 1);  // factor on the radius of each corner
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    const double length = (points[j].position - points[i].position).norm();
    const double factor = length / std::max(fillets[i].reach + fillets[j].reach, length);
    room[i] = std::min(room[i], factor);
    room[j] = std::min(room[j], factor);
  }
  Curve curve;
  for (std::size_t i = 0; i < n; ++i) {
    const Fillet f{fillets[i].reach * room[i], fillets[i].turn};
    if (f.reach > 0) {
      append_arc(points[i], points[(i + n - 1) % n].position, f, curve.points);
    } else {
      curve.corners.push_back(static_cast<int>(curve.points.size()));
      curve.points.push_back(points[i].position);
    }
  }
  return curve;
}

Curve smooth_curve(const std::vector<ControlPoint>& points) {
  assert(points.size() >= 3);
  const std::size_t n = points.size();
  const auto at = [&](std::size_t i) -> const ControlPoint& { return points[i % n]; };
  Curve curve;
  for (std::size_t i = 0; i < n; ++i) {
    const ControlPoint &a = at(i), &b = at(i + 1);
    if (a.radius == 0) curve.corners.push_back(static_cast<int>(curve.points.size()));
    // At a corner the curve runs out straight: its own reflection stands in for the neighbour.
    const Vec2 before = a.radius == 0 ? Vec2(2 * a.position - b.position) : at(i + n - 1).position;
    const Vec2 after = b.radius == 0 ? Vec2(2 * b.position - a.position) : at(i + 2).position;
    append_piece({before, a.position, b.position, after}, curve.points);
  }
  return curve;
}

Curve circle(const Vec2& centre, double radius) {
  Curve curve;
  constexpr int kSteps = 8 * kStepsPerPiece;
  for (int k = 0; k < kSteps; ++k)
    curve.points.push_back(centre + rotated(Vec2(radius, 0), 2 * pi * k / kSteps));
  return curve;
}

std::vector<ControlPoint> mirrored(const std::vector<ControlPoint>& right_half) {
  std::vector<ControlPoint> whole = right_half;
  for (auto p = right_half.rbegin(); p != right_half.rend(); ++p)
    if (p->position.x() != 0) whole.push_back({{-p->position.x(), p->position.y()}, p->radius});
  return whole;
}

double length_of(const Curve& curve) { return arc_lengths(curve.points).back(); }

Loop resample(const Curve& curve, int count) {
  assert(count >= 3 && count >= static_cast<int>(curve.corners.size()));
  std::vector<int> stops = curve.corners;
  if (stops.empty()) stops.push_back(0);
  // Start at the first stop, so that no stretch runs over the end of the array.
  Loop points = curve.points;
  std::rotate(points.begin(), points.begin() + stops.front(), points.end());
  const std::vector<double> lengths = arc_lengths(points);
  std::vector<double> starts, stretches;
  for (const int stop : stops) starts.push_back(lengths[stop - stops.front()]);
  for (std::size_t i = 0; i < starts.size(); ++i)
    stretches.push_back((i + 1 < starts.size() ? starts[i + 1] : lengths.back()) - starts[i]);
  const std::vector<int> shares = share_out(stretches, count);
  Loop samples;
  for (std::size_t i = 0; i < starts.size(); ++i)
    for (int k = 0; k < shares[i]; ++k)
      samples.push_back(point_at(points, lengths, starts[i] + stretches[i] * k / shares[i]));
  return samples;
}

}  // namespace foldless
