// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/clamp.h"

#include <cmath>

namespace foldless {
namespace {

/// A rotation by φ as (cos φ, sin φ).
using Turn = Vec2;

/// The direction of (x, y); any one of (0, 0).
Turn turn_of(double x, double y) {
  const double length = std::sqrt(x * x + y * y);
  return length > 0 ? Turn(x / length, y / length) : Turn(1, 0);
}

/// By φ/2, or by that and π: a frame may be turned by half a turn.
Turn half(const Turn& t) {
  if (t.x() >= 0) {
    const double cosine = std::sqrt(0.5 * (1 + t.x()));
    return {cosine, 0.5 * t.y() / cosine};
  }
  const double sine = std::sqrt(0.5 * (1 - t.x()));
  return {0.5 * t.y() / sine, sine};
}

/// V ⊗ U: takes vec(S) to vec(U S Vᵀ).
Eigen::Matrix4d singular_frame(const Mat2& J) {
  const Turn difference = half(turn_of(J(0, 0) + J(1, 1), J(1, 0) - J(0, 1)));
  const Turn sum = half(turn_of(J(0, 0) - J(1, 1), J(1, 0) + J(0, 1)));
  const double cc = sum.x() * difference.x(), ss = sum.y() * difference.y();
  const double sc = sum.y() * difference.x(), cs = sum.x() * difference.y();
  Mat2 U, V;
  U << cc - ss, -(sc + cs), sc + cs, cc - ss;
  V << cc + ss, -(sc - cs), sc - cs, cc + ss;
  Eigen::Matrix4d frame;
  for (int c = 0; c < 2; ++c)
    for (int s = 0; s < 2; ++s) frame.block<2, 2>(2 * c, 2 * s) = V(c, s) * U;
  return frame;
}

/// Takes the part `clamping` of a negative eigenvalue away from the symmetric block of rows and
/// columns i and j. False when it has none.
bool clamp_block(Eigen::Matrix4d& matrix, int i, int j, double clamping) {
  const double middle = 0.5 * (matrix(i, i) + matrix(j, j));
  const double half_difference = 0.5 * (matrix(i, i) - matrix(j, j));
  const double radius = std::sqrt(half_difference * half_difference + matrix(i, j) * matrix(i, j));
  const double least = middle - radius, greatest = middle + radius;
  if (least >= 0) return false;
  // What is left of M with eigenvalues λ₁ < 0 < λ₂ is λ₂ / (λ₂ − λ₁) · (M − λ₁ I).
  const double factor = greatest > 0 ? greatest / (greatest - least) : 0;
  const auto mix = [&](double before, double clamped) {
    return before + clamping * (clamped - before);
  };
  matrix(i, i) = mix(matrix(i, i), factor * (matrix(i, i) - least));
  matrix(j, j) = mix(matrix(j, j), factor * (matrix(j, j) - least));
  matrix(i, j) = matrix(j, i) = mix(matrix(i, j), factor * matrix(i, j));
  return true;
}

}  // namespace

Eigen::Matrix4d clamped_hessian(const Eigen::Matrix4d& hessian, const Mat2& J, double clamping) {
  const Eigen::Matrix4d frame = singular_frame(J);
  Eigen::Matrix4d blocks = frame.transpose() * hessian * frame;
  const bool first = clamp_block(blocks, 0, 3, clamping);
  const bool second = clamp_block(blocks, 1, 2, clamping);
  if (!first && !second) return hessian;
  return frame * blocks * frame.transpose();
}

}  // namespace foldless
