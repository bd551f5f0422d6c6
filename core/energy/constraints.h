// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/handle.h"
#include "core/mesh/triangle.h"

namespace foldless {

/// The positional constraints Cu = p, whose energy is E_c. One column or entry a handle. Hard
/// handles are those that are not soft.
struct Constraints {
  std::vector<int> vertices;  ///< the rows of C
  Points targets;             ///< p, 2 × #handles [length]
  Eigen::VectorXd weights;    ///< factors on α: 1, or the weight of a soft handle
  std::vector<bool> soft;     ///< soft handles do not count in ‖P‖²
  /// Held: the hard handles stay where they are and leave the unknowns; their targets do not enter
  /// E.
  bool held = false;

  int count() const { return static_cast<int>(vertices.size()); }
  bool is_eliminated(int handle) const { return held && !soft[static_cast<std::size_t>(handle)]; }
};

/// The constraints of a list of handles.
Constraints constraints_of(const std::vector<Handle>& handles);

/// Which of so many vertices have a hard handle.
std::vector<bool> have_hard_handles(const Constraints& constraints, int vertices);

/// Σ w_i‖u_i − p_i‖²: E_c of eq. 5 with the weights of soft handles; without held handles.
/// [length²]
double penalty(const Constraints& constraints, const Points& u);

/// ‖P(u)‖² = Σ‖u_i − p_i‖² over the handles that are not soft. [length²]
double handle_error_squared(const Constraints& constraints, const Points& u);

/// Where the handles are: Cu, 2 × #handles.
Points handle_positions(const Constraints& constraints, const Points& u);

/// The same constraints with other targets, 2 × #handles.
Constraints with_targets(Constraints constraints, Points targets);

/// The same constraints, hard handles held.
Constraints held(Constraints constraints);

}  // namespace foldless
