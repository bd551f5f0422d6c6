// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <stop_token>
#include <vector>

#include "core/energy/constraints.h"
#include "core/iteration.h"
#include "core/mesh/mesh_pair.h"
#include "core/remesh/collapse_edges.h"
#include "core/remesh/flip_edges.h"
#include "core/remesh/split_edges.h"
#include "core/solve/newton_system.h"
#include "core/solve/update_vertices.h"

namespace foldless {

/// How a stage of `foldless` ended.
enum class Progress {
  arrived,  ///< the handles are on their targets
  locked    ///< it gains no more
};

/// What holds for a run of `foldless` as a whole.
struct RunSettings {
  EnergySettings energy;                 ///< of the scene
  double eta = 1e-3;                     ///< least relative gain of a flip
  bool condition_test = true;            ///< cancel flips that raise cond
  double diagonal = 1;                   ///< D of the rest mesh, the unit of all lengths
  int first_removable = 0;               ///< vertices of lower index stay
  std::vector<int> fixed_boundary = {};  ///< sorted vertices whose boundary edges are not split
};

/// What the stages of `foldless` work on: a mesh pair, its handles and the Newton system that moves
/// it. A copy is another way to go; it adds to the same effort. `settings` outlives it.
struct Workspace {
  MeshPair mesh;
  Constraints constraints;  ///< with the real targets
  NewtonSystem system;
  const RunSettings* settings;
  std::vector<std::vector<int>> parts;  ///< see handles_of_components()

  Workspace(MeshPair start, Constraints handles, const RunSettings& run_settings, Effort& effort);

  /// The scene's energy with the handles held, and a twentieth of the weights of its barriers: they
  /// show handles the way round what would lock, and only spoil the shape that they end in.
  Energy held_energy() const;
  /// From 20,000 vertices on: where a step of the whole mesh costs so much that what bounds it is
  /// seen to by itself, and that the last ones are spared.
  bool is_large() const { return mesh.vertex_count() >= 20000; }
  /// ‖P(u)‖².
  double error() const { return handle_error_squared(constraints, mesh.deformed()); }
  /// Whether the map is in the feasible set of the scene's energy.
  bool is_feasible() const;
  /// Where the handles are, 2 × #handles.
  Points handles() const { return handle_positions(constraints, mesh.deformed()); }

  /// Flips nothing where all flips together gain less than `least_gain` of E_d + E_b.
  int flip_edges(const EnergySettings& energy, double least_gain = 0);
  /// Splits the edges in the way; returns how many. See split_edges() of core/remesh.
  int split_edges(const std::vector<MovingDirection>& directions);
  /// Splits every edge in its middle.
  void refine();
  /// Splits edges of the triangles whose σ₁/σ₂ is `least` or more, at most so many; returns how
  /// many. See split_distorted() of core/remesh.
  int split_distorted(double least, int most = std::numeric_limits<int>::max());
  /// Returns how many vertices were removed; see collapse_edges() of core/remesh.
  int collapse_edges(const CollapseSettings& collapse);
  bool has_vertices_of_splits() const { return mesh.vertex_count() > settings->first_removable; }
  /// Moves vertices of splits in both meshes, while a sweep lowers `energy` by more than
  /// `least_gain`. See relocate_vertices() of core/remesh.
  VertexUpdate relocate_vertices(const EnergySettings& energy, double least_gain,
                                 const std::stop_token& token);
  /// Takes another mesh with the same handle vertices.
  void set_mesh(MeshPair other);
  /// Takes the same mesh with other positions and edges flipped.
  void set_flipped_mesh(MeshPair other);

  /// The record of an update that lowered `energy`, whatever targets it aimed at.
  Iteration record(const VertexUpdate& update, const Energy& energy, Phase phase);
  /// Brings that record up to date where the mesh was replaced in the same step.
  void measure_again(Iteration& last, const Energy& energy);

 private:
  Energy with_real_targets(const Energy& energy) const;
};

}  // namespace foldless
