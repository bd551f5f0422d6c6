// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stop_token>

#include "core/mesh/mesh_pair.h"
#include "core/solve/damped_system.h"

namespace foldless {

/// What one vertex update did.
struct VertexUpdate {
  bool cancelled = false;         ///< nothing was changed
  double mu = 0;                  ///< shift that made eq. 6 solvable
  double clamping = 0;            ///< part of the negative curvature that ∇²E was without
  double step_length = 0;         ///< t of the line search; 0 when no decrease was found
  double decrement = 0;           ///< −½∇E·s, the decrease that the quadratic model promises
  double step_infinity_norm = 0;  ///< ‖u_n − u_{n−1}‖_∞, the largest change of a coordinate
};

/// UpdateVertices (4.2): one damped Newton step on the full E, eq. 6, and a line search. Moves the
/// deformed positions of `mesh`; they stay feasible on the whole way. The system's factor is used
/// again when RelaxVertices left one.
VertexUpdate update_vertices(DampedSystem& system, MeshPair& mesh, const Energy& energy,
                             const std::stop_token& token);

/// Solves with the factor that the system holds, searches along the step and moves the mesh:
/// what UpdateVertices and RelaxVertices have in common. Counts U.
VertexUpdate move_vertices(NewtonSystem& system, MeshPair& mesh, const Energy& energy, double mu);

/// Searches along a step and moves the mesh. Precondition: E and ∇E are assembled. Counts U.
VertexUpdate move_along(const Points& step, NewtonSystem& system, MeshPair& mesh,
                        const Energy& energy);

}  // namespace foldless
