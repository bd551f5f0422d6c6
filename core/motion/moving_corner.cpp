// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/moving_corner.h"

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace foldless {
namespace {

bool is_finite(const MovingPoint& p) { return p.from.allFinite() && p.to.allFinite(); }

bool is_finite(const MovingCorner& corner) {
  return is_finite(corner.apex) && is_finite(corner.first) && is_finite(corner.second);
}

/// The sides from the apex to its neighbours at times 0 and 1.
template <typename Number>
struct Sides {
  struct Side {
    Number x, y;
  };
  std::array<Side, 2> first, second;

  explicit Sides(const MovingCorner& c)
      : first{between(c.apex.from, c.first.from), between(c.apex.to, c.first.to)},
        second{between(c.apex.from, c.second.from), between(c.apex.to, c.second.to)} {}

 private:
  static Side between(const Vec2& a, const Vec2& b) {
    return {Number(b.x()) - Number(a.x()), Number(b.y()) - Number(a.y())};
  }
};

/// (1 − t)² start + t (1 − t) middle + t² end.
template <typename Number>
struct Quadratic {
  Number start, middle, end;
};

/// A double and how far it can be from the number that it stands for.
struct Rounded {
  double value, error;
  double least() const { return value - error; }
  double largest() const { return value + error; }
};

/// The sum of products of differences that were rounded each. 8 ε covers the errors of four
/// products, with ε = 2⁻⁵³; the addend covers underflow. What overflows is not finite, and fails
/// every comparison.
template <typename... Products>
Rounded sum_of(Products... products) {
  return {(products + ...), 0x1p-50 * (std::abs(products) + ...) + 1e-300};
}

/// Twice the area of the triangle over time, in doubles.
Quadratic<Rounded> rounded_area(const MovingCorner& corner) {
  const Sides<double> s(corner);
  const auto& [a, b] = s.first;
  const auto& [c, d] = s.second;
  return {sum_of(a.x * c.y, -a.y * c.x), sum_of(a.x * d.y, -a.y * d.x, b.x * c.y, -b.y * c.x),
          sum_of(b.x * d.y, -b.y * d.x)};
}

/// The product of the two sides' lengths with the cosine between them, likewise.
Quadratic<Rounded> rounded_dot(const MovingCorner& corner) {
  const Sides<double> s(corner);
  const auto& [a, b] = s.first;
  const auto& [c, d] = s.second;
  return {sum_of(a.x * c.x, a.y * c.y), sum_of(a.x * d.x, a.y * d.y, b.x * c.x, b.y * c.y),
          sum_of(b.x * d.x, b.y * d.y)};
}

/// Positive all the time, whatever the errors are. False is no answer.
bool is_surely_positive(const Quadratic<Rounded>& q) {
  const double start = q.start.least(), middle = q.middle.least(), end = q.end.least();
  if (!(start > 0 && end > 0)) return false;
  if (middle >= 0) return true;
  // With s = t / (1 − t): start + middle s + end s² has no root. The factor covers the rounding of
  // the products, the least product their underflow.
  const double product = start * end;
  return product > 1e-290 && middle * middle < (4 - 1e-14) * product;
}

Quadratic<Rounded> negated(const Quadratic<Rounded>& q) {
  const auto minus = [](const Rounded& r) { return Rounded{-r.value, r.error}; };
  return {minus(q.start), minus(q.middle), minus(q.end)};
}

/// k₀ + k₁ t + k₂ t².
struct Polynomial {
  mpq_class k0, k1, k2;
};

Polynomial polynomial(const Quadratic<mpq_class>& q) {
  return {q.start, q.middle - 2 * q.start, q.start - q.middle + q.end};
}

Polynomial exact_area(const MovingCorner& corner) {
  const Sides<mpq_class> s(corner);
  const auto& [a, b] = s.first;
  const auto& [c, d] = s.second;
  return polynomial({a.x * c.y - a.y * c.x, a.x * d.y - a.y * d.x + b.x * c.y - b.y * c.x,
                     b.x * d.y - b.y * d.x});
}

Polynomial exact_dot(const MovingCorner& corner) {
  const Sides<mpq_class> s(corner);
  const auto& [a, b] = s.first;
  const auto& [c, d] = s.second;
  return polynomial({a.x * c.x + a.y * c.y, a.x * d.x + a.y * d.y + b.x * c.x + b.y * c.y,
                     b.x * d.x + b.y * d.y});
}

/// x + y √d with d ≥ 0: roots of quadratics with rational coefficients, and polynomials of them.
struct Surd {
  mpq_class x, y, d;

  int sign() const {
    const int of_x = sgn(x), of_root = sgn(d) == 0 ? 0 : sgn(y);
    if (of_x == 0 || of_root == 0 || of_x == of_root) return of_x != 0 ? of_x : of_root;
    const mpq_class x2 = x * x, y2d = y * y * d;
    return of_x * sgn(mpq_class(x2 - y2d));
  }
  double rounded() const {
    constexpr int kBits = 512;
    const mpf_class root = sqrt(mpf_class(d, kBits));
    return mpf_class(mpf_class(x, kBits) + mpf_class(y, kBits) * root).get_d();
  }
};

/// The value of p at a moment.
Surd value_at(const Polynomial& p, const Surd& t) {
  return {p.k0 + p.k1 * t.x + p.k2 * (t.x * t.x + t.y * t.y * t.d),
          p.k1 * t.y + 2 * p.k2 * t.x * t.y, t.d};
}

/// The roots in [0, 1], ascending; none of a constant.
std::vector<Surd> roots_in_time(const Polynomial& p) {
  std::vector<Surd> roots;
  if (sgn(p.k2) == 0) {
    if (sgn(p.k1) != 0) roots.push_back({-p.k0 / p.k1, 0, 0});
  } else {
    const mpq_class discriminant = p.k1 * p.k1 - 4 * p.k0 * p.k2;
    if (sgn(discriminant) >= 0) {
      const mpq_class x = -p.k1 / (2 * p.k2), y = 1 / mpq_class(2 * abs(p.k2));
      roots = {{x, -y, discriminant}, {x, y, discriminant}};
    }
  }
  std::erase_if(roots, [](const Surd& t) {
    return t.sign() < 0 || Surd{1 - t.x, -t.y, t.d}.sign() < 0;
  });
  return roots;
}

double moment_of(const Surd& root) { return std::clamp(root.rounded(), 0.0, 1.0); }

}  // namespace

std::optional<double> first_flat_moment(const MovingCorner& corner) {
  if (!is_finite(corner)) return 0;
  if (is_surely_positive(rounded_area(corner))) return std::nullopt;
  const Polynomial area = exact_area(corner);
  if (sgn(area.k0) <= 0) return 0;
  const std::vector<Surd> roots = roots_in_time(area);
  if (roots.empty()) return std::nullopt;
  return moment_of(roots.front());
}

std::optional<double> first_closed_moment(const MovingCorner& corner) {
  if (!is_finite(corner)) return 0;
  const Quadratic<Rounded> rounded = rounded_area(corner);
  if (is_surely_positive(rounded) || is_surely_positive(negated(rounded)) ||
      is_surely_positive(negated(rounded_dot(corner))))
    return std::nullopt;
  const Polynomial area = exact_area(corner), dot = exact_dot(corner);
  if (sgn(area.k0) == 0 && sgn(dot.k0) > 0) return 0;
  for (const Surd& root : roots_in_time(area))
    if (value_at(dot, root).sign() > 0) return moment_of(root);
  return std::nullopt;
}

}  // namespace foldless
