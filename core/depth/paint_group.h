// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/depth/boundary_curves.h"
#include "core/depth/paint_layers.h"
#include "core/mesh/parts.h"

namespace foldless {

/// Triangles that may lie in front of one another, whole components; those of other groups are all
/// in front of them or all behind them.
class PaintGroup {
 public:
  /// `of_mesh`: of every triangle the place among those of the mesh.
  PaintGroup(std::shared_ptr<const Triangles> triangles, std::vector<int> of_mesh,
             int vertex_count);

  /// Looks where they cover each other. Precondition: as OverlapSearch::find().
  void find_overlaps(const Points& points);
  void clear_overlaps() { overlaps_.clear(); }
  bool has_overlaps() const { return !overlaps_.empty(); }

  /// Writes their layers, from `first` on, to where they are in the mesh; returns the next layer.
  int paint(const PaintKeys& keys_of_mesh, int first, std::vector<int>& layers) const;
  /// All in one layer: what overlaps there are does not count.
  int paint_flat(int first, std::vector<int>& layers) const;

 private:
  std::shared_ptr<const Triangles> triangles_;
  std::vector<int> of_mesh_;
  int vertex_count_;
  BoundaryCurves boundary_;
  std::optional<OverlapSearch> search_;  ///< made when something overlaps
  std::vector<Overlap> overlaps_;
};

/// The depth of a handle, by its vertex.
using HandleDepth = std::pair<int, double>;

/// The groups of a mesh, from back to front: parts of which no depth lies between those of another
/// are apart, so that nobody needs to know where they overlap. Without parts one group.
std::vector<PaintGroup> paint_groups(const std::shared_ptr<const Triangles>& triangles,
                                     int vertex_count, std::span<const MeshPart> parts,
                                     std::span<const HandleDepth> handles);

}  // namespace foldless
