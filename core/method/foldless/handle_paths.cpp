// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/handle_paths.h"

#include <cmath>
#include <complex>
#include <numbers>

namespace foldless {
namespace {

using Complex = std::complex<double>;

/// Handles that travel less than this part of the longest way count as standing still.
constexpr double kStandingStill = 1e-3;
/// Samples along a path from which its length is taken.
constexpr int kSamples = 16;

Complex complex(const Vec2& p) { return {p.x(), p.y()}; }

/// z → a z + b, the least-squares similarity of the moving handles.
struct Similarity {
  Complex a = 1;
  Complex b = 0;
};

Similarity similarity_of(const Points& starts, const Points& targets) {
  const double longest = (targets - starts).colwise().norm().maxCoeff();
  Complex mean_start = 0, mean_target = 0;
  double count = 0;
  const auto moves = [&](Eigen::Index i) {
    return (targets.col(i) - starts.col(i)).norm() > kStandingStill * longest;
  };
  for (Eigen::Index i = 0; i < starts.cols(); ++i) {
    if (!moves(i)) continue;
    mean_start += complex(starts.col(i));
    mean_target += complex(targets.col(i));
    ++count;
  }
  if (count == 0) return {};
  mean_start /= count;
  mean_target /= count;
  Complex product = 0;
  double spread = 0;
  for (Eigen::Index i = 0; i < starts.cols(); ++i) {
    if (!moves(i)) continue;
    const Complex z = complex(starts.col(i)) - mean_start;
    product += std::conj(z) * (complex(targets.col(i)) - mean_target);
    spread += std::norm(z);
  }
  const Complex a = spread > 0 && std::abs(product) > 0 ? product / spread : 1;
  return {a, mean_target - a * mean_start};
}

}  // namespace

double HandlePaths::common_turn(const Points& starts, const Points& targets) {
  return starts.cols() == 0 ? 0 : std::arg(similarity_of(starts, targets).a);
}

HandlePaths::HandlePaths(PathKind kind, const Points& starts, const Points& targets)
    : kind_(kind), starts_(starts), targets_(targets) {
  const auto count = static_cast<std::size_t>(starts.cols());
  angles_.assign(count, 0);
  lengths_.assign(count, 0);
  if (count == 0) return;
  const auto [a, b] = similarity_of(starts, targets);
  if (std::abs(1.0 - a) < 1e-6) kind_ = PathKind::straight;  // there is no centre
  if (kind_ == PathKind::turning) {
    const Complex centre = b / (1.0 - a);
    centre_ = {centre.real(), centre.imag()};
    const double common = std::arg(a);
    for (std::size_t i = 0; i < count; ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      const Complex from = complex(starts.col(column)) - centre;
      const Complex to = complex(targets.col(column)) - centre;
      double angle = std::arg(to * std::conj(from));
      // Of the angles that differ by full turns, the one nearest to that of the others.
      const double turn = 2 * std::numbers::pi;
      angle += turn * std::round((common - angle) / turn);
      const bool stands = (targets.col(column) - starts.col(column)).norm() == 0;
      angles_[i] = stands ? 0 : angle;
    }
  }
  for (int i = 0; i < static_cast<int>(count); ++i)
    for (int k = 0; k < kSamples; ++k)
      lengths_[static_cast<std::size_t>(i)] +=
          (at(i, (k + 1.0) / kSamples) - at(i, double(k) / kSamples)).norm();
}

Vec2 HandlePaths::at(int handle, double lambda) const {
  const Vec2 from = starts_.col(handle), to = targets_.col(handle);
  if (lambda >= 1) return to;
  if (kind_ == PathKind::straight) return from + lambda * (to - from);
  const double angle = angles_[static_cast<std::size_t>(handle)];
  const double r0 = (from - centre_).norm(), r1 = (to - centre_).norm();
  if (r0 == 0) return from + lambda * (to - from);
  const Vec2 unit = (from - centre_) / r0;
  const double c = std::cos(lambda * angle), s = std::sin(lambda * angle);
  return centre_ +
         (r0 + lambda * (r1 - r0)) * Vec2(c * unit.x() - s * unit.y(), s * unit.x() + c * unit.y());
}

}  // namespace foldless
