// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/triangle.h"

namespace foldless {

/// Where handles are on the way from their start (λ = 0) to their targets (λ = 1).
class HandlePath {
 public:
  /// Every handle on its own straight line. Both are 2 × #handles.
  static HandlePath straight(Points start, Points target);
  /// The handles that move go together along the similarity z ↦ a z + b that is nearest to their
  /// motion: a^λ grows and turns, the rest goes straight. Handles that turn by 180° do not meet in
  /// a point. Where fewer than two places move it is straight.
  static HandlePath similar(Points start, Points target);

  /// The positions at λ in [0, 1]; the targets bit for bit at 1. 2 × #handles.
  Points at(double lambda) const;
  /// False when similar() found nothing to turn and is straight.
  bool is_similar() const { return log_scale_ != 0 || angle_ != 0; }

 private:
  Points start_;
  Points target_;
  Vec2 start_centre_ = Vec2::Zero();  ///< of the handles that move
  Vec2 target_centre_ = Vec2::Zero();
  double log_scale_ = 0;  ///< log |a|
  double angle_ = 0;      ///< arg a
};

}  // namespace foldless
