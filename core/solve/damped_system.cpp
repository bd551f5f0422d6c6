// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/damped_system.h"

#include "core/solve/newton_step.h"

namespace foldless {
namespace {

constexpr double kFirstLambda = 0.1;
constexpr double kLambdaAfterSuccess = 1e-5;
constexpr double kLambdaFactor = 10;
constexpr double kLargestLambda = 1e17;

}  // namespace

DampedSystem::DampedSystem(const MeshPair& mesh, const Constraints& constraints, Effort& effort)
    : NewtonSystem(mesh, constraints, effort), lambda_(kFirstLambda) {}

bool DampedSystem::factorize_plain(const std::stop_token& token) {
  factor().obey(token);
  if (token.stop_requested() || !factorize(*this, 0)) return false;
  lambda_ = kLambdaAfterSuccess;
  return true;
}

std::optional<double> DampedSystem::factorize_damped(bool plain_failed,
                                                     const std::stop_token& token) {
  if (token.stop_requested()) return std::nullopt;
  analyze(*this);
  if (token.stop_requested()) return std::nullopt;
  if (!plain_failed && factorize_plain(token)) return 0;
  factor().obey(token);
  double mu = 0;
  for (bool first = true; lambda_ <= kLargestLambda; first = false) {
    if (token.stop_requested()) return std::nullopt;
    mu += lambda_;
    if (factorize(*this, mu)) {
      if (first) lambda_ /= kLambdaFactor;
      return mu;
    }
    if (token.stop_requested()) return std::nullopt;
    lambda_ *= kLambdaFactor;
  }
  lambda_ = kFirstLambda;
  return std::nullopt;
}

}  // namespace foldless
