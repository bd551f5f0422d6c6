// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>

#include "core/method/foldless/approach.h"
#include "core/method/foldless/settle.h"
#include "core/method/method.h"

namespace foldless {

/// The project's own method: keeps the paper's idea, the tessellation as a degree of freedom, and
/// replaces what holds it back. One vertex update a step. The problem's rest mesh has a
/// bounding-box diagonal of about 1.
class Foldless final : public Method {
 public:
  explicit Foldless(Problem problem);

  std::unique_ptr<Method> clone() const override;
  std::optional<Iteration> step(std::stop_token token) override;
  std::optional<Outcome> outcome() const override { return outcome_; }
  const MeshPair& mesh() const override { return work_.mesh; }
  void set_targets(const Points& targets) override;
  StageTimes times() const override { return work_.system.times; }

 private:
  std::optional<Iteration> advance(std::stop_token token);
  Iteration record(const VertexUpdate& update, const Positions& positions, Phase phase);
  void after_approach(Progress progress);
  bool split();

  Workspace work_;
  std::variant<Approach, Settle> stage_;
  std::optional<Outcome> outcome_;
  int inner_ = 0;
  int split_rounds_ = 0;
  double locked_error_ = 0;  ///< ‖P‖² when the approach locked last
  double seconds_ = 0;
};

}  // namespace foldless
