// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/descent.h"

#include <algorithm>
#include <utility>

#include "core/solve/newton_step.h"

namespace foldless {
namespace {

/// Rounding may leave a clamped matrix just short of positive definite, and far from it where
/// triangles are nearly crushed.
constexpr double kLeastShift = 1e-9;
constexpr double kLargestShift = 1e13;
constexpr double kShiftFactor = 100;

/// After a step shorter than this ∇²E is factorized anew: with an old factor many more such steps
/// follow, where the map is about to fold.
constexpr double kShortStep = 0.1;

constexpr int kMostFullStepsWanted = 8;
constexpr double kFirstPart = 0.5;
constexpr double kLeastPart = 0.25;

VertexUpdate step_along(const Points& step, NewtonSystem& system, MeshPair& mesh,
                        const Energy& energy) {
  const VertexUpdate update = move_along(step, system, mesh, energy);
  if (update.step_length < kShortStep) system.factor().set_far();
  return update;
}

}  // namespace

std::optional<LaggedStep> rough_clamped_step(
    NewtonSystem& system, const std::stop_token& token,
    const std::function<std::optional<LaggedStep>()>& lagged) {
  HessianFactor& factor = system.factor();
  factor.obey(token);
  analyze(system);
  while (!token.stop_requested()) {
    const Precision precision = factor.for_iterations(system.hessian());
    if (precision == Precision::full) break;
    std::optional<LaggedStep> step;
    if (factorize(system, 0, precision)) step = lagged();
    if (step && !step->is_indefinite) return step;
    if (!token.stop_requested()) factor.set_too_rough();
  }
  return std::nullopt;
}

std::optional<double> factorize_clamped(NewtonSystem& system, const std::stop_token& token,
                                        double last_shift) {
  system.factor().obey(token);
  analyze(system);
  for (double mu = std::max(kLeastShift, last_shift / kShiftFactor); mu < kLargestShift;
       mu *= kShiftFactor) {
    if (token.stop_requested()) return std::nullopt;
    if (factorize(system, mu)) return mu;
  }
  return std::nullopt;
}

VertexUpdate Descent::step(NewtonSystem& system, MeshPair& mesh, const Energy& energy,
                           const std::stop_token& token) {
  system.factor().obey(token);
  if (clamping_ < 1) {
    system.assemble(energy, mesh.deformed(), clamping_);
    if (token.stop_requested()) return {.cancelled = true};
    if (const std::optional<Points> step = step_if_definite(system, token)) {
      VertexUpdate update = step_along(*step, system, mesh, energy);
      update.clamping = clamping_;
      after_partly_clamped(update.step_length);
      return update;
    }
    if (token.stop_requested()) return {.cancelled = true};
    after_failure();
  }
  system.assemble(energy, mesh.deformed(), 1);
  double mu = 0;
  std::optional<LaggedStep> step;
  if (use_ == FactorUse::lagged) {
    const auto lagged = [&] { return lagged_newton_step(system); };
    step = lagged();
    if (!step || step->is_indefinite) step = rough_clamped_step(system, token, lagged);
  }
  if (!step) {
    const std::optional<double> shift = factorize_clamped(system, token, last_shift_);
    if (!shift) return {.cancelled = token.stop_requested()};
    last_shift_ = mu = *shift;
    step = LaggedStep{newton_step(system)};
  }
  VertexUpdate update = step_along(step->step, system, mesh, energy);
  update.mu = mu;
  update.clamping = 1;
  after_clamped(update.step_length);
  return update;
}

/// Nothing where ∇²E as assembled is not positive definite.
std::optional<Points> Descent::step_if_definite(NewtonSystem& system,
                                                const std::stop_token& token) const {
  if (use_ == FactorUse::lagged)
    if (std::optional<LaggedStep> lagged = lagged_newton_step(system)) {
      if (lagged->is_indefinite) return std::nullopt;
      return std::move(lagged->step);
    }
  if (token.stop_requested()) return std::nullopt;
  while (use_ == FactorUse::lagged) {
    const Precision precision = system.factor().for_iterations(system.hessian());
    if (precision == Precision::full) break;
    if (!factorize(system, 0, precision)) return std::nullopt;
    if (std::optional<LaggedStep> rough = lagged_newton_step(system))
      return rough->is_indefinite ? std::nullopt : std::optional(std::move(rough->step));
    if (token.stop_requested()) return std::nullopt;
    system.factor().set_too_rough();
  }
  if (!factorize(system, 0)) return std::nullopt;
  return newton_step(system);
}

void Descent::after_partly_clamped(double step_length) {
  full_steps_wanted_ = 1;
  if (step_length == 1) clamping_ = clamping_ > kLeastPart ? clamping_ / 2 : 0;
}

void Descent::after_failure() {
  clamping_ = 1;
  full_steps_ = 0;
  full_steps_wanted_ = std::min(2 * full_steps_wanted_, kMostFullStepsWanted);
}

void Descent::after_clamped(double step_length) {
  full_steps_ = step_length == 1 ? full_steps_ + 1 : 0;
  if (full_steps_ >= full_steps_wanted_) clamping_ = kFirstPart;
}

}  // namespace foldless
