// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stop_token>
#include <vector>

#include "core/energy/positions.h"
#include "core/mesh/mesh_pair.h"
#include "core/remesh/collapse_edges.h"
#include "core/remesh/flip_edges.h"
#include "core/remesh/split_edges.h"
#include "core/solve/descend.h"
#include "core/solve/newton_system.h"
#include "core/solve/update_vertices.h"

namespace foldless {

/// How a stage of `foldless` stands after a step.
enum class Progress {
  running,
  arrived,   ///< the stage reached what it is for
  locked,    ///< it gains no more
  cancelled  ///< the token was set; nothing changed
};

/// What the stages of `foldless` work on: a mesh pair, its handles and the Newton system that moves
/// it. The rest diagonal is about 1. Plain copyable state.
struct Workspace {
  MeshPair mesh;
  Positions positions;  ///< with the real targets
  NewtonSystem system;
  double eta;                            ///< least relative gain of a flip
  bool condition_test;                   ///< cancel flips that raise cond
  std::vector<int> fixed_boundary = {};  ///< sorted vertices whose boundary edges are not split
  CurvatureChoice curvature = {};
  int flips = 0;
  int splits = 0;
  int steps_since_flips = 0;

  /// ‖P(u)‖².
  double error() const { return handle_error_squared(positions, mesh.deformed()); }
  /// One step of descend() towards `aimed`; edges are flipped when the step was short, and every
  /// few steps.
  VertexUpdate descend(const Positions& aimed, std::stop_token token);
  /// Flips nothing where all flips together gain less than `least_gain` of E_d + E_b.
  int flip_edges(double least_gain = 0);
  /// Splits the edges in the way; returns how many. See split_edges() of core/remesh.
  int split_edges(const std::vector<MovingDirection>& directions);
  /// Splits every edge in its middle.
  void refine();
  /// Returns how many vertices were removed; see collapse_edges() of core/remesh.
  int collapse_edges(const CollapseSettings& settings);
  /// Takes another mesh with the same handle vertices.
  void set_mesh(MeshPair other);
  /// Puts the handles exactly on their targets if no triangle leaves the feasible set on the way,
  /// nor E_d + E_b grows much.
  bool snap();
  /// Adds up what was spent on a copy of this workspace: counters and times go on from there.
  void take_counts(const Workspace& copy);
  /// Takes another energy for the same mesh.
  void set_energy(const EnergySettings& energy);
};

}  // namespace foldless
