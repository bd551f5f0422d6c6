// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/clamp.h"

#include <cmath>

namespace foldless {
namespace {

/// Clamps the symmetric block of rows and columns i and j.
void clamp_block(Eigen::Matrix4d& matrix, int i, int j) {
  const double middle = 0.5 * (matrix(i, i) + matrix(j, j));
  const double radius = std::hypot(0.5 * (matrix(i, i) - matrix(j, j)), matrix(i, j));
  const double least = middle - radius, greatest = middle + radius;
  if (least >= 0) return;
  // What is left of M with eigenvalues λ₁ < 0 < λ₂ is λ₂ / (λ₂ − λ₁) · (M − λ₁ I).
  const double factor = greatest > 0 ? greatest / (greatest - least) : 0;
  matrix(i, i) = factor * (matrix(i, i) - least);
  matrix(j, j) = factor * (matrix(j, j) - least);
  matrix(i, j) = matrix(j, i) = factor * matrix(i, j);
}

Mat2 rotation(double angle) {
  Mat2 R;
  R << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  return R;
}

/// V ⊗ U: takes vec(S) to vec(U S Vᵀ).
Eigen::Matrix4d singular_frame(const Mat2& J) {
  const double difference = std::atan2(J(1, 0) - J(0, 1), J(0, 0) + J(1, 1));
  const double sum = std::atan2(J(1, 0) + J(0, 1), J(0, 0) - J(1, 1));
  const Mat2 U = rotation(0.5 * (sum + difference));
  const Mat2 V = rotation(0.5 * (sum - difference));
  Eigen::Matrix4d frame;
  for (int c = 0; c < 2; ++c)
    for (int s = 0; s < 2; ++s) frame.block<2, 2>(2 * c, 2 * s) = V(c, s) * U;
  return frame;
}

}  // namespace

Eigen::Matrix4d clamped_hessian(const Eigen::Matrix4d& hessian, const Mat2& J) {
  const Eigen::Matrix4d frame = singular_frame(J);
  Eigen::Matrix4d blocks = frame.transpose() * hessian * frame;
  clamp_block(blocks, 0, 3);
  clamp_block(blocks, 1, 2);
  return frame * blocks * frame.transpose();
}

}  // namespace foldless
