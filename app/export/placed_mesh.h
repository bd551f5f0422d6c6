// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <vector>

#include "app/export/polygon_clip.h"
#include "core/mesh/parts.h"
#include "core/snapshot.h"
#include "render/camera.h"
#include "render/mesh_sheets.h"
#include "render/view_options.h"

namespace foldless {

/// A mesh as it lies in a pane, in the sheets in which it is painted.
struct PlacedMesh {
  std::vector<glm::dvec2> places;  ///< of the vertices, pixels of the pane, y down
  std::vector<glm::dvec2> rest;    ///< of the vertices
  Box rest_box;
  std::vector<std::uint32_t> corners;  ///< three a triangle
  std::vector<int> sheets;             ///< of the triangles
  std::vector<int> parts;              ///< of the triangles, see MeshParts
  std::size_t part_count = 1;
  LayerLists triangles;  ///< by sheet, in each by part
  EdgeLists edges;
  std::array<LayerLists, 3> edges_by_sheet;    ///< by EdgeSet
  std::vector<std::array<int, 3>> neighbours;  ///< over the side after corner k; −1: none

  std::array<std::size_t, 3> vertices_of(int triangle) const;
  std::size_t sheet_count() const;
  std::span<const int> triangles_of(std::size_t sheet) const;
};

/// Where a mesh is seen.
struct MeshView {
  Pose pose = Pose::deformed;
  Camera camera;
  glm::dvec2 viewport;                     ///< pixels
  std::shared_ptr<const MeshParts> parts;  ///< null: none
};

/// Precondition: the snapshot has triangles and a rest mesh.
PlacedMesh placed_mesh(const Snapshot& snapshot, const MeshView& view);

/// A triangle and what hides the soft edges between it and its neighbours, which would let through
/// what is behind: over each of some sides a strip inside of the neighbour there, all convex.
/// `grows` is asked for the triangle and each neighbour. Over those that are painted later and hide
/// the strip it should; triangles that are painted as one shape have no edge between them.
std::vector<Polygon> grown(const PlacedMesh& mesh, int triangle,
                           const std::function<bool(std::size_t, std::size_t)>& grows);

/// The same for triangles that are painted one after another, in the order of `numbers`; at inner
/// vertices, where many soft corners meet, the first triangle gets a dot besides.
class PaintedInTurn {
 public:
  /// The references have to outlive it.
  PaintedInTurn(const PlacedMesh& mesh, const std::vector<int>& numbers);

  std::vector<Polygon> pieces_of(int triangle) const;

 private:
  const PlacedMesh& mesh_;
  const std::vector<int>& numbers_;
  std::vector<int> first_at_;  ///< the first triangle at a vertex; −1 on the boundary
};

}  // namespace foldless
