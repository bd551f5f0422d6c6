// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/method/foldless/settle.h"

namespace foldless {

/// The last stage: settles, and where splits left vertices that nobody needs, collapses them and
/// settles again, as long as E Kᵉ stays about what it was. What raised it too much is undone.
/// Where a triangle is still crushed then, it settles once more with a larger exponent.
class Tidy {
 public:
  /// σ₁/σ₂ from which a triangle counts as crushed.
  static constexpr double kCrushed = 1e3;

  /// Vertices of index `first_removable` or more are no handles and may go.
  Tidy(Workspace& workspace, int first_removable);
  Progress step(Workspace& workspace, std::stop_token token, VertexUpdate& update);
  /// The handles as the energy sees them in this stage.
  const Positions& positions() const { return settle_.positions(); }

 private:
  /// What a round began with.
  struct Before {
    MeshPair mesh;
    double merit;  ///< E Kᵉ
  };

  bool is_crowded(const MeshPair& mesh) const;
  bool collapse(Workspace& workspace);
  bool begin_uncrushing(Workspace& workspace);

  int first_removable_;
  Settle settle_;
  int rounds_ = 0;
  bool is_collapsing_ = true;
  std::optional<Before> before_;
};

}  // namespace foldless
