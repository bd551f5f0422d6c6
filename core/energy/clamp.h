// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "core/energy/density.h"

namespace foldless {

/// What makes a ∇²ψ positive semidefinite when it is added: minus its negative part, as a sum over
/// an orthonormal basis of the 2×2 matrices J in which ∇²ψ is a 2×2 block and two numbers [SGK19].
template <class Real>
struct NegativeCurvature {
  Matrix2<Real> rotation;    ///< R/√2, R the rotation closest to J
  Matrix2<Real> reflection;  ///< E/√2, E the reflection closest to J
  Real of_rotation;          ///< ≥ 0, of the block of those two
  Real of_both;              ///< the entry beside the diagonal
  Real of_reflection;        ///< ≥ 0
  Real of_twist;             ///< ≥ 0, of R/√2 turned by 90°
  Real of_flip;              ///< ≥ 0, of E/√2 turned by 90°
};

/// The basis, and what ∇²ψ is in it. J = ½ (s₊ R + s₋ E) with s₊ = σ₁ + σ₂ and s₋ = σ₁ − σ₂, and
/// its cofactors are ½ (s₊ R − s₋ E): the map D of the second derivative of det keeps R and turns
/// E round.
template <class Real>
class Curvature {
 public:
  FOLDLESS_INLINED Curvature(const DerivativesOf<Real>& d, const Matrix2<Real>& J)
      : conformal_x_(J.a + J.d),
        conformal_y_(J.b - J.c),
        anticonformal_x_(J.a - J.d),
        anticonformal_y_(J.b + J.c),
        plus2_(conformal_x_ * conformal_x_ + conformal_y_ * conformal_y_),
        minus2_(anticonformal_x_ * anticonformal_x_ + anticonformal_y_ * anticonformal_y_),
        twist_(d.norm + d.det),
        flip_(d.norm - d.det),
        first_(twist_ + plus2_ * (0.5 * (d.norm_norm + d.det_det) + d.norm_det)),
        second_(flip_ + minus2_ * (0.5 * (d.norm_norm + d.det_det) - d.norm_det)),
        difference_(d.norm_norm - d.det_det) {}

  /// Where ∇²ψ is positive semidefinite.
  FOLDLESS_INLINED auto is_positive() const {
    const Real both2 = 0.25 * plus2_ * minus2_ * difference_ * difference_;
    return both(both(twist_ >= 0, flip_ >= 0), both(first_ >= 0, first_ * second_ >= both2));
  }

  FOLDLESS_INLINED NegativeCurvature<Real> negative_part() const {
    const Real plus = square_root(plus2_), minus = square_root(minus2_);
    const Real beside = 0.5 * plus * minus * difference_;
    // Any rotation and any reflection will do where there is no closest one.
    const auto is_turned = plus > 0, is_reflected = minus > 0;
    const Real r_x = M_SQRT1_2 * select(is_turned, conformal_x_ / plus, 1);
    const Real r_y = M_SQRT1_2 * select(is_turned, conformal_y_ / plus, 0);
    const Real e_x = M_SQRT1_2 * select(is_reflected, anticonformal_x_ / minus, 1);
    const Real e_y = M_SQRT1_2 * select(is_reflected, anticonformal_y_ / minus, 0);
    NegativeCurvature<Real> result{{r_x, r_y, -r_y, r_x}, {e_x, e_y, e_y, -e_x}, 0, 0, 0, 0, 0};
    add_block(beside, result);
    result.of_twist = select(twist_ >= 0, 0, -twist_);
    result.of_flip = select(flip_ >= 0, 0, -flip_);
    return result;
  }

 private:
  /// Minus the negative part of the block M: what is left of an M with eigenvalues λ₁ < 0 < λ₂ is
  /// λ₂ / (λ₂ − λ₁) · (M − λ₁ I).
  FOLDLESS_INLINED void add_block(const Real& beside, NegativeCurvature<Real>& result) const {
    const Real middle = 0.5 * (first_ + second_);
    const Real half_difference = 0.5 * (first_ - second_);
    const Real radius = square_root(half_difference * half_difference + beside * beside);
    const Real least = middle - radius, greatest = middle + radius;
    const Real factor = select(greatest > 0, greatest / (greatest - least), 0);
    const auto is_none = least >= 0;
    result.of_rotation = select(is_none, 0, factor * (first_ - least) - first_);
    result.of_both = select(is_none, 0, (factor - 1) * beside);
    result.of_reflection = select(is_none, 0, factor * (second_ - least) - second_);
  }

  Real conformal_x_, conformal_y_, anticonformal_x_, anticonformal_y_;
  Real plus2_, minus2_;  ///< s₊², s₋²
  Real twist_, flip_;    ///< the two numbers
  Real first_, second_;  ///< the diagonal of the block
  Real difference_;
};

}  // namespace foldless
