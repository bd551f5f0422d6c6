// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/handle_path.h"

#include <cmath>
#include <complex>
#include <utility>

namespace foldless {
namespace {

/// The similarity of scale e^{log_scale} and angle about the origin.
Mat2 similarity(double log_scale, double angle) {
  const std::complex<double> a = std::exp(std::complex<double>(log_scale, angle));
  Mat2 A;
  A << a.real(), -a.imag(), a.imag(), a.real();
  return A;
}

}  // namespace

HandlePath HandlePath::straight(Points start, Points target) {
  HandlePath path;
  path.start_ = std::move(start);
  path.target_ = std::move(target);
  return path;
}

// Least squares over the moving handles: a = Σ conj(z − z₀)(p − p₀) / Σ|z − z₀|² with the centres
// z₀ of the starts z and p₀ of the targets p.
HandlePath HandlePath::similar(Points start, Points target) {
  HandlePath path = straight(std::move(start), std::move(target));
  int moving = 0;
  for (Eigen::Index i = 0; i < path.start_.cols(); ++i) {
    if (path.start_.col(i) == path.target_.col(i)) continue;
    path.start_centre_ += path.start_.col(i);
    path.target_centre_ += path.target_.col(i);
    ++moving;
  }
  if (moving == 0) return path;
  path.start_centre_ /= moving;
  path.target_centre_ /= moving;
  std::complex<double> numerator = 0;
  double denominator = 0;
  for (Eigen::Index i = 0; i < path.start_.cols(); ++i) {
    if (path.start_.col(i) == path.target_.col(i)) continue;
    const Vec2 z = path.start_.col(i) - path.start_centre_;
    const Vec2 p = path.target_.col(i) - path.target_centre_;
    numerator += std::conj(std::complex(z.x(), z.y())) * std::complex(p.x(), p.y());
    denominator += z.squaredNorm();
  }
  if (!(std::abs(numerator) > 1e-12 * denominator)) return path;
  path.log_scale_ = std::log(std::abs(numerator) / denominator);
  path.angle_ = std::arg(numerator);
  return path;
}

Points HandlePath::at(double lambda) const {
  if (lambda >= 1) return target_;
  if (!is_similar()) return start_ + lambda * (target_ - start_);
  // The residual of the similarity at the targets goes straight.
  const Mat2 whole = similarity(log_scale_, angle_);
  const Mat2 part = similarity(lambda * log_scale_, lambda * angle_);
  Points points = start_;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    if (start_.col(i) == target_.col(i)) continue;
    const Vec2 z = start_.col(i) - start_centre_;
    const Vec2 residual = target_.col(i) - (whole * z + target_centre_);
    points.col(i) =
        part * z + start_centre_ + lambda * (target_centre_ - start_centre_) + lambda * residual;
  }
  return points;
}

}  // namespace foldless
