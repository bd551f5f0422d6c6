// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace foldless {

class Draft;
class Motion;

enum class StatusKind { empty, ready, solving, converged, stopped, blocked, paused, failed };

/// What the solver does, in words: "Solving 12/1000", "Converged", "Blocked: …".
struct Status {
  StatusKind kind = StatusKind::empty;
  std::string words;
  double residual = 0;  ///< largest distance of a handle from its target [length]
};

/// How a draft stands.
Status status_of(const Draft& draft);
/// How the moment at the play head stands, and what is proved of the whole animation.
Status status_of(const Motion& motion);

}  // namespace foldless
