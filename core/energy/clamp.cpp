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

/// The symmetric block of rows and columns i and j of Fᵀ H F, which is what is left of H in two
/// columns of the frame F.
struct Block {
  Eigen::Vector4d i, j;  ///< the columns of F
  double ii, jj, ij;

  Block(const Eigen::Matrix4d& hessian, const Eigen::Vector4d& column_i,
        const Eigen::Vector4d& column_j)
      : i(column_i), j(column_j) {
    const Eigen::Vector4d image = hessian * j;
    ii = i.dot(hessian * i);
    jj = j.dot(image);
    ij = i.dot(image);
  }
};

/// Takes the part `clamping` of a negative eigenvalue of the block away from H.
void clamp(const Block& block, double clamping, Eigen::Matrix4d& hessian) {
  const double middle = 0.5 * (block.ii + block.jj);
  const double half_difference = 0.5 * (block.ii - block.jj);
  const double radius = std::sqrt(half_difference * half_difference + block.ij * block.ij);
  const double least = middle - radius, greatest = middle + radius;
  if (least >= 0) return;
  // What is left of M with eigenvalues λ₁ < 0 < λ₂ is λ₂ / (λ₂ − λ₁) · (M − λ₁ I).
  const double factor = greatest > 0 ? greatest / (greatest - least) : 0;
  const double ii = clamping * (factor * (block.ii - least) - block.ii);
  const double jj = clamping * (factor * (block.jj - least) - block.jj);
  const double ij = clamping * (factor - 1) * block.ij;
  const Eigen::Vector4d by_i = ii * block.i + ij * block.j, by_j = ij * block.i + jj * block.j;
  hessian.noalias() += by_i * block.i.transpose() + by_j * block.j.transpose();
}

}  // namespace

Eigen::Matrix4d clamped_hessian(const Eigen::Matrix4d& hessian, const Mat2& J, double clamping) {
  const Eigen::Matrix4d frame = singular_frame(J);
  Eigen::Matrix4d result = hessian;
  clamp(Block(hessian, frame.col(0), frame.col(3)), clamping, result);
  clamp(Block(hessian, frame.col(1), frame.col(2)), clamping, result);
  return result;
}

}  // namespace foldless
