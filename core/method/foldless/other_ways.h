// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/method/foldless/attempt.h"

namespace foldless {

/// What is tried when the approach locked, in this order: transports from the rest state, as
/// transport_plans() has them; on from the nearest place where one of them locked, on the mesh as
/// it is and on a refined one; transports in random orders, which are persistent; and, of a small
/// mesh, all of the transports on a refined one.
class OtherWays {
 public:
  /// `energy` is that of the scene. With `approach_first`, for an approach that did not begin at
  /// rest, one that does is tried before.
  OtherWays(const EnergySettings& energy, bool approach_first);

  /// The next way; nothing when all were tried. `at_rest` has the mesh that ways begin with.
  std::optional<Attempt> next(const Workspace& at_rest);
  /// Takes a mesh on which a transport locked.
  void take_locked(const Workspace& transport);
  /// How many were tried.
  int count() const { return count_; }

 private:
  Attempt going_on(const Workspace& at_rest);

  EnergySettings energy_;
  bool is_approach_next_;
  std::size_t transports_ = 0;        ///< tried
  int going_on_ = 0;                  ///< tried
  std::optional<Workspace> nearest_;  ///< where transports locked
  int count_ = 0;
};

}  // namespace foldless
