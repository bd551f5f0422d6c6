// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cone/second_order_cone.h"

#include <cmath>
#include <limits>

namespace foldless {
namespace {

/// Js, where sᵀJs = s₀² − s₁² − s₂².
Cone3 mirrored(const Cone3& s) { return {s[0], -s[1], -s[2]}; }

double tail_norm(const Cone3& s) { return std::hypot(s[1], s[2]); }

/// √(sᵀJs) without cancellation near the boundary.
double hyperbolic_norm(const Cone3& s) { return std::sqrt(depth(s) * (s[0] + tail_norm(s))); }

}  // namespace

double depth(const Cone3& s) { return s[0] - tail_norm(s); }

Cone3 cone_product(const Cone3& u, const Cone3& v) {
  return {u.dot(v), u[0] * v[1] + v[0] * u[1], u[0] * v[2] + v[0] * u[2]};
}

Cone3 cone_quotient(const Cone3& u, const Cone3& v) {
  const double determinant = depth(u) * (u[0] + tail_norm(u));
  const double x = (u[0] * v[0] - u.tail<2>().dot(v.tail<2>())) / determinant;
  return {x, (v[1] - x * u[1]) / u[0], (v[2] - x * u[2]) / u[0]};
}

// A hyperbolic rotation that takes s to a multiple of e takes d to r, and e + t r leaves Q where
// 1 + t r₀ = t‖(r₁, r₂)‖.
double largest_step(const Cone3& s, const Cone3& d) {
  const double norm = hyperbolic_norm(s);
  const Cone3 unit = s / norm;
  const double r0 = (unit[0] * d[0] - unit.tail<2>().dot(d.tail<2>())) / norm;
  const Eigen::Vector2d r1 =
      d.tail<2>() / norm - (r0 + d[0] / norm) / (unit[0] + 1) * unit.tail<2>();
  const double rate = r1.norm() - r0;
  return rate > 0 ? 1 / rate : std::numeric_limits<double>::infinity();
}

NesterovTodd::NesterovTodd(const Cone3& s, const Cone3& z) {
  const double s_norm = hyperbolic_norm(s);
  const double z_norm = hyperbolic_norm(z);
  const Cone3 s_unit = s / s_norm;
  const Cone3 z_unit = z / z_norm;
  const double gamma = std::sqrt((1 + s_unit.dot(z_unit)) / 2);
  const Cone3 w = (s_unit + mirrored(z_unit)) / (2 * gamma);
  const double beta = std::sqrt(s_norm / z_norm);
  const Cone3 v = (w + Cone3::UnitX()) / std::sqrt(2 * (w[0] + 1));
  const Cone3 Jv = mirrored(v);
  const Cone3 Jw = mirrored(w);
  const Eigen::Matrix3d J = Cone3(1, -1, -1).asDiagonal();
  W = beta * (2 * v * v.transpose() - J);
  W_inv = (2 * Jv * Jv.transpose() - J) / beta;
  W_inv2 = (2 * Jw * Jw.transpose() - J) / (beta * beta);
  lambda = W * z;
}

}  // namespace foldless
