// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/approach.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/method/foldless/flipping_descent.h"
#include "core/method/foldless/snap.h"

namespace foldless {
namespace approaching {

constexpr double kFirstAlpha = 10;
constexpr double kAlphaFactor = 10;
constexpr double kLastAlpha = 5e7;
/// A way of a handle from which the weakest penalty is right. [D]
constexpr double kLongWay = 0.1;

/// A level of α has done its work when no vertex moves more than this [D], or when the model
/// promises less than this part of E.
constexpr double kSmallStep = 1e-3;
constexpr double kSmallDecrement = 1e-2;

/// A leg is over, reached or not, after so many steps, or where one promises less than this part of
/// E, or as near to its stop, ‖P‖²/D².
constexpr int kMostStepsOfALeg = 8;
constexpr double kSmallDecrementOfALeg = 0.05;
constexpr double kNearStop = 1e-2;

constexpr int kMostMultiplierSteps = 8;
constexpr double kMultipliersBelow = 1e-5;  ///< ‖P‖²/D²

/// Stalled: ‖P‖² fell by less than this part in so many steps.
constexpr double kGainOfAWatch = 0.25;
constexpr int kStepsOfAWatch = 25;

/// A short way needs no detour: the start is the stiffer, with the square, the shorter the way.
double first_alpha(const Workspace& work) {
  const double way = (work.constraints.targets - work.handles()).colwise().norm().maxCoeff();
  const double long_way = kLongWay * work.settings->diagonal;
  const double shortness = long_way / std::max(way, long_way * 1e-4);
  return std::clamp(kFirstAlpha * shortness * shortness, kFirstAlpha, kLastAlpha);
}

/// The stops of an approach, one after the other.
class Legs {
 public:
  explicit Legs(std::vector<Points> stops) : stops_(std::move(stops)) {}

  const Points& stop() const { return stops_[next_]; }
  bool is_last() const { return next_ + 1 == stops_.size(); }
  /// After a step [D] of which the model promised a part of E, with ‖P‖² of the stop [D²].
  bool is_over(double step, double decrement, double error) {
    return ++steps_ >= kMostStepsOfALeg || step < kSmallStep || decrement < kSmallDecrementOfALeg ||
           error < kNearStop;
  }
  /// Precondition: it is not the last.
  const Points& go_on() {
    steps_ = 0;
    return stops_[++next_];
  }

 private:
  std::vector<Points> stops_;
  std::size_t next_ = 0;
  int steps_ = 0;
};

/// Looks after every so many steps whether ‖P‖² still falls.
class Watch {
 public:
  explicit Watch(double error) : error_(error) {}

  bool has_stalled(double error) {
    if (++steps_ < kStepsOfAWatch) return false;
    const bool stalled = error > (1 - kGainOfAWatch) * error_;
    *this = Watch(error);
    return stalled;
  }

 private:
  double error_;  ///< ‖P‖² when it began
  int steps_ = 0;
};

/// The reaction of the mesh keeps the handles off their targets by multipliers / 2α: the aim moves
/// by as much to the other side.
void move_aim(const Workspace& work, Constraints& aimed) {
  aimed.targets -= work.handles() - work.constraints.targets;
}

}  // namespace approaching

Steps<Progress> approach(Workspace& work, FactorUse use, std::vector<Points> stops) {
  using namespace approaching;
  const double D = work.settings->diagonal;
  Energy energy{work.settings->energy, work.constraints};
  double& alpha = energy.settings.alpha;
  alpha = first_alpha(work);
  if (stops.empty()) stops = {work.constraints.targets};
  Legs legs(std::move(stops));
  energy.constraints.targets = legs.stop();
  FlippingDescent descent(use);
  Watch watch(work.error());
  int multiplier_steps = 0;
  const auto next = [&](const std::stop_token& token) { return descent.step(work, energy, token); };
  while (true) {
    const VertexUpdate update = co_await vertex_update(next);
    const bool has_arrived = is_near(work) && snap(work, energy.settings);
    co_yield work.record(update, energy, Phase::approach);
    if (has_arrived) co_return Progress::arrived;

    const double E = work.system.objective().value(energy, work.mesh.deformed()).total();
    const double step = update.step_infinity_norm / D, decrement = update.decrement / E;
    const double error = work.error();
    if (!legs.is_last()) {
      const double to_stop = handle_error_squared(energy.constraints, work.mesh.deformed());
      if (!legs.is_over(step, decrement, to_stop / (D * D))) continue;
      energy.constraints.targets = legs.go_on();
      watch = Watch(error);
      continue;
    }
    const bool has_stalled = watch.has_stalled(error);
    if (has_stalled && alpha >= kLastAlpha) co_return Progress::locked;
    const bool is_settled = has_stalled || step < kSmallStep || decrement < kSmallDecrement;
    if (!is_settled) continue;
    if (alpha < kLastAlpha) {
      alpha = std::min(kLastAlpha, kAlphaFactor * alpha);
      watch = Watch(error);
    } else if (error <= kMultipliersBelow * D * D && multiplier_steps < kMostMultiplierSteps) {
      ++multiplier_steps;
      move_aim(work, energy.constraints);
    }
  }
}

}  // namespace foldless
