// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/handle_paths.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "core/method/similarity.h"

namespace foldless {
namespace {

/// Handles that travel less than this part of the longest way count as standing still.
constexpr double kStandingStill = 1e-3;
/// Samples along a path from which its length is taken.
constexpr int kSamples = 16;
/// |1 − a| below which a similarity has no fixed point to speak of.
constexpr double kLeastTurn = 1e-6;

Vec2 vector(const std::complex<double>& z) { return {z.real(), z.imag()}; }

/// Those that move.
std::vector<int> moving_of(const Points& starts, const Points& targets) {
  std::vector<int> moving;
  if (starts.cols() == 0) return moving;
  const double longest = (targets - starts).colwise().norm().maxCoeff();
  for (int i = 0; i < static_cast<int>(starts.cols()); ++i)
    if ((targets.col(i) - starts.col(i)).norm() > kStandingStill * longest) moving.push_back(i);
  return moving;
}

}  // namespace

CommonTurn common_turn(const Points& starts, const Points& targets) {
  const std::vector<int> moving = moving_of(starts, targets);
  if (moving.empty()) return {};
  const Points from = starts(Eigen::all, moving), to = targets(Eigen::all, moving);
  const Similarity similarity = similarity_of(from, to);
  return {.angle = std::arg(similarity.a),
          .left = left_of_way(similarity, from, to) / (to - from).norm(),
          .moving = static_cast<int>(moving.size())};
}

HandlePaths::HandlePaths(PathKind kind, Points starts, Points targets)
    : kind_(kind), starts_(std::move(starts)), targets_(std::move(targets)) {
  const std::vector<int> moving = moving_of(starts_, targets_);
  const auto [a, from, to] =
      similarity_of(starts_(Eigen::all, moving), targets_(Eigen::all, moving));
  a_ = a;
  start_centre_ = vector(from);
  end_centre_ = vector(to);
  if (std::abs(1.0 - a_) < kLeastTurn) kind_ = PathKind::straight;
  if (kind_ == PathKind::turning) find_turns();
}

void HandlePaths::find_turns() {
  const std::complex<double> centre =
      (complex(end_centre_) - a_ * complex(start_centre_)) / (1.0 - a_);
  start_centre_ = end_centre_ = vector(centre);
  const double turn = 2 * std::numbers::pi;
  for (Eigen::Index i = 0; i < starts_.cols(); ++i) {
    const std::complex<double> from = complex(starts_.col(i)) - centre,
                               to = complex(targets_.col(i)) - centre;
    const double angle = std::arg(to * std::conj(from));
    // Of the angles that differ by full turns, the one nearest to that of the others.
    const bool stands = starts_.col(i) == targets_.col(i);
    angles_.push_back(stands ? 0 : angle + turn * std::round((std::arg(a_) - angle) / turn));
  }
}

Vec2 HandlePaths::at(int handle, double lambda) const {
  const Vec2 from = starts_.col(handle);
  Vec2 to = targets_.col(handle);
  if (lambda >= 1 || from == to) return to;
  if (kind_ == PathKind::similar) {
    const std::complex<double> z = complex(from - start_centre_);
    const Vec2 residual = to - (vector(a_ * z) + end_centre_);
    return vector(std::pow(a_, lambda) * z) + start_centre_ +
           lambda * (end_centre_ - start_centre_ + residual);
  }
  const double r0 = (from - start_centre_).norm(), r1 = (to - start_centre_).norm();
  if (kind_ == PathKind::straight || r0 == 0) return from + lambda * (to - from);
  const std::complex<double> direction = complex(from - start_centre_) / r0;
  const double angle = angles_[static_cast<std::size_t>(handle)];
  return start_centre_ +
         vector((r0 + lambda * (r1 - r0)) * std::polar(1.0, lambda * angle) * direction);
}

Points HandlePaths::at(double lambda) const {
  Points points = starts_;
  for (int i = 0; i < static_cast<int>(starts_.cols()); ++i) points.col(i) = at(i, lambda);
  return points;
}

double HandlePaths::length(int handle) const {
  double length = 0;
  for (int k = 0; k < kSamples; ++k)
    length += (at(handle, (k + 1.0) / kSamples) - at(handle, double(k) / kSamples)).norm();
  return length;
}

}  // namespace foldless
