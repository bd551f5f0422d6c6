// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/triangle.h"
#include "core/snapshot.h"

namespace foldless {

/// The positional constraints Cu = p and their energy E_c. One column or entry a handle.
struct Positions {
  std::vector<int> vertices;  ///< the rows of C
  Points targets;             ///< p, 2 × #handles [length]
  Eigen::VectorXd weights;    ///< factors on α: 1, or the weight of a soft handle
  std::vector<bool> soft;     ///< soft handles do not count in ‖P‖²
  /// True: handles that are not soft stay where they are and leave the unknowns; the targets of
  /// those do not enter E.
  bool held = false;

  int count() const { return static_cast<int>(vertices.size()); }
  bool is_eliminated(int handle) const { return held && !soft[static_cast<std::size_t>(handle)]; }
};

/// The constraints of a list of handles.
Positions positions_of(const std::vector<Handle>& handles);

/// Σ w_i‖u_i − p_i‖²: E_c of eq. 5 with the weights of soft handles; without held handles.
/// [length²]
double penalty(const Positions& positions, const Points& u);

/// ‖P(u)‖² = Σ‖u_i − p_i‖² over the handles that are not soft. [length²]
double handle_error_squared(const Positions& positions, const Points& u);

/// The same constraints with the current positions as targets: what RelaxVertices aims at (4.2).
Positions held_where_they_are(const Positions& positions, const Points& u);

}  // namespace foldless
