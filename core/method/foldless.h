// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>

#include "core/method/foldless/approach.h"
#include "core/method/foldless/pursue.h"
#include "core/method/foldless/tidy.h"
#include "core/method/foldless/transport.h"
#include "core/method/method.h"

namespace foldless {

/// The project's own method: keeps the paper's idea, the tessellation as a degree of freedom, and
/// replaces what holds it back. One vertex update a step. The problem's rest mesh has a
/// bounding-box diagonal of about 1.
///
/// Approach → Tidy where nothing blocks. A locked approach splits edges at the handles that are
/// not home and begins again; when that gains no more, transports are tried on a second mesh while
/// mesh() stays the best one so far. Where targets move: Pursue → Tidy, and the approach only
/// when that locks.
class Foldless final : public Method {
 public:
  /// β per unit rest area: independent of the number of triangles, unlike the paper's.
  static constexpr double kBeta = 2;

  explicit Foldless(Problem problem);

  std::unique_ptr<Method> clone() const override;
  std::optional<Iteration> step(std::stop_token token) override;
  std::optional<Outcome> outcome() const override { return outcome_; }
  const MeshPair& mesh() const override { return work_.mesh; }
  void set_targets(const Points& targets) override;
  StageTimes times() const override { return work_.system.times; }

 private:
  /// A transport on a mesh of its own.
  struct Attempt {
    Workspace work;
    Transport transport;
  };

  std::optional<Iteration> advance(std::stop_token token);
  std::optional<Iteration> approach(Approach& stage, std::stop_token token);
  std::optional<Iteration> transport(Attempt& attempt, std::stop_token token);
  std::optional<Iteration> pursue(Pursue& stage, std::stop_token token);
  std::optional<Iteration> settle(Tidy& stage, std::stop_token token);
  Iteration record(Workspace& work, const VertexUpdate& update, const Positions& positions);
  void after_locked_approach();
  void begin_next_transport();
  bool split();

  MeshPair initial_;     ///< where transports start: its rest state
  int first_removable_;  ///< vertices of lower index stay
  EnergySettings energy_;
  Workspace work_;
  std::variant<Approach, Attempt, Pursue, Tidy> stage_;
  std::optional<Outcome> outcome_;
  int inner_ = 0;
  int split_rounds_ = 0;
  std::vector<TransportPlan> plans_;
  std::size_t next_plan_ = 0;
  double locked_error_ = 0;  ///< ‖P‖² when the approach locked last
  double seconds_ = 0;
};

}  // namespace foldless
