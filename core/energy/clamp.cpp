// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/clamp.h"

#include <algorithm>
#include <cmath>

namespace foldless {
namespace {

/// Entries of a symmetric 2×2 matrix.
struct Block {
  double first, both, second;
};

/// Minus the negative part of M. What is left of M with eigenvalues λ₁ < 0 < λ₂ is
/// λ₂ / (λ₂ − λ₁) · (M − λ₁ I).
Block without_positive_part(const Block& m) {
  const double middle = 0.5 * (m.first + m.second);
  const double half_difference = 0.5 * (m.first - m.second);
  const double radius = std::sqrt(half_difference * half_difference + m.both * m.both);
  const double least = middle - radius, greatest = middle + radius;
  if (least >= 0) return {0, 0, 0};
  const double factor = greatest > 0 ? greatest / (greatest - least) : 0;
  return {factor * (m.first - least) - m.first, (factor - 1) * m.both,
          factor * (m.second - least) - m.second};
}

}  // namespace

// J = ½ (s₊ R + s₋ E) with s₊ = σ₁ + σ₂ and s₋ = σ₁ − σ₂, and its cofactors are ½ (s₊ R − s₋ E):
// the map D of the second derivative of det keeps R and turns E round.
std::optional<NegativeCurvature> negative_curvature(const DensityDerivatives& d, const Mat2& J) {
  const Vec2 conformal(J(0, 0) + J(1, 1), J(1, 0) - J(0, 1));
  const Vec2 anticonformal(J(0, 0) - J(1, 1), J(1, 0) + J(0, 1));
  const double plus2 = conformal.squaredNorm(), minus2 = anticonformal.squaredNorm();
  const double twist = d.norm + d.det, flip = d.norm - d.det;
  Block block{twist + plus2 * (0.5 * (d.norm_norm + d.det_det) + d.norm_det), 0,
              flip + minus2 * (0.5 * (d.norm_norm + d.det_det) - d.norm_det)};
  const double both2 =
      0.25 * plus2 * minus2 * (d.norm_norm - d.det_det) * (d.norm_norm - d.det_det);
  if (twist >= 0 && flip >= 0 && block.first >= 0 && block.first * block.second >= both2)
    return std::nullopt;
  const double plus = std::sqrt(plus2), minus = std::sqrt(minus2);
  block.both = 0.5 * plus * minus * (d.norm_norm - d.det_det);
  const Block negative = without_positive_part(block);
  // Any rotation and any reflection will do where there is no closest one.
  const Vec2 r = M_SQRT1_2 * (plus > 0 ? Vec2(conformal / plus) : Vec2(1, 0));
  const Vec2 e = M_SQRT1_2 * (minus > 0 ? Vec2(anticonformal / minus) : Vec2(1, 0));
  NegativeCurvature result;
  result.rotation << r.x(), -r.y(), r.y(), r.x();
  result.reflection << e.x(), e.y(), e.y(), -e.x();
  result.of_rotation = negative.first;
  result.of_both = negative.both;
  result.of_reflection = negative.second;
  result.of_twist = std::max(0.0, -twist);
  result.of_flip = std::max(0.0, -flip);
  return result;
}

}  // namespace foldless
