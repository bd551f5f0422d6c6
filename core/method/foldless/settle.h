// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/method/foldless/workspace.h"

namespace foldless {

/// The handles are on their targets and stay there, eliminated from the unknowns; Newton's method
/// lowers E Kᵉ, with flips on the way: K is the sum over the triangles of k² as in
/// conformal_square_value(), each counting the same, and the small exponent ε says what part of E
/// lower distortions are worth. Small triangles weigh next to nothing in E, however distorted.
/// Arrives when neither moves nor flips gain anything.
class Settle {
 public:
  /// ε: a percent off every k is worth 2 ε percent of E.
  static constexpr double kExponent = 0.04;

  explicit Settle(Workspace& workspace, double exponent = kExponent);
  Progress step(Workspace& workspace, std::stop_token token, VertexUpdate& update);
  /// The handles as the energy sees them in this stage.
  const Positions& positions() const { return held_; }
  /// E with the handles held.
  double energy_of(const Workspace& workspace) const;
  /// E Kᵉ, with the mean in place of the sum so that it can be compared when triangles went.
  double merit_of(const Workspace& workspace) const;

 private:
  Progress descend(Workspace& workspace, std::stop_token token, VertexUpdate& update);

  double exponent_;
  Positions held_;
  std::optional<double> energy_;  ///< E where the last step ended
  int steps_ = 0;
  int failures_ = 0;       ///< steps that found no decrease
  bool is_plain_ = false;  ///< the next step lowers E alone
};

}  // namespace foldless
