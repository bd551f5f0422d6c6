// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/handle.h"
#include "core/iteration.h"
#include "core/mesh/triangle.h"

namespace foldless {

/// One state of a run, immutable and in input units: what the window, the files and the renderer
/// may see. It is proved to be valid unless it says otherwise. Arrays that seldom change are shared
/// between snapshots.
struct Snapshot {
  std::uint64_t generation = 0;  ///< which load of the worker it belongs to
  std::uint64_t revision =
      0;  ///< changes whenever `triangles` or `rest` changes, unique in a process
  std::shared_ptr<const Triangles> triangles;  ///< 3 × #F, counter-clockwise
  std::shared_ptr<const Points> rest;          ///< 2 × #V, M
  Points deformed;                             ///< 2 × #V, M′
  /// Edges between original vertices that the original mesh lacks, sorted.
  std::shared_ptr<const std::vector<Edge>> flipped_edges;
  int original_vertices = 0;  ///< vertices with this index or more came from splits
  std::vector<Handle> handles;
  std::optional<Iteration> iteration;  ///< absent before the first update
  /// What methods that may fold have made of M′, counted with exact predicates.
  int folded_triangles = 0;  ///< clockwise or of no area
  int branch_vertices = 0;   ///< interior vertices that unfolded triangles wind round twice
  /// Boundary vertices of M′ whose angles add up to 2π or more; see InjectivityReport.
  int overlapping_boundary_vertices = 0;

  /// True when M′ is locally injective but for boundary vertices: a run may go on from it.
  bool is_valid() const { return folded_triangles == 0 && branch_vertices == 0; }
};

}  // namespace foldless
