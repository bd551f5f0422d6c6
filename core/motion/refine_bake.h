// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/motion/frame_map.h"
#include "core/motion/growing_mesh.h"

namespace foldless {

/// The mesh of a bake and where the frames take its vertices.
class RefineBake {
 public:
  /// `original` has to outlive it.
  RefineBake(const Triangles& original, const Points& rest);

  /// Takes one more frame; returns its number.
  std::size_t add_frame(std::shared_ptr<const Snapshot> snapshot);
  /// Adds vertices until every frame has all triangles counter-clockwise and is within a distance
  /// of the solver's map [length], or there are so many vertices. Tells what share of its triangles
  /// is. False when the token was set.
  bool refine(double tolerance, int most_vertices, const std::function<void(double)>& progress,
              const std::stop_token& token);

  const GrowingMesh& mesh() const { return mesh_; }
  Points deformed(std::size_t frame) const;
  /// The same; the frame is gone then, so that it takes no memory twice.
  Points take_deformed(std::size_t frame);
  /// The largest distance to the maps of all frames. [length]
  double deviation() const;

 private:
  /// A point at which a triangle and a frame's map part: on the edge (a, b), or inside.
  struct Parting {
    double distance = 0;
    Vec2 at = Vec2::Zero();  ///< at rest
    std::optional<Edge> edge = std::nullopt;
  };
  std::vector<Parting> partings(int t, std::size_t frame) const;
  std::shared_ptr<const RestCover> cover_of(const Snapshot& snapshot);
  void add_crossings(int t, std::size_t frame, int other, std::vector<Parting>& found) const;
  void add_vertices(int t, std::size_t frame, int other, std::vector<Parting>& found) const;
  std::optional<std::vector<Parting>> what_to_mend(int t, double tolerance) const;
  void mark(const std::vector<int>& made, std::vector<bool>& changed);
  void mend(int t, const std::vector<Parting>& partings, std::vector<bool>& changed);
  std::pair<Edge, double> longest_edge(int t) const;
  void place_last_vertex(int origin);
  bool is_counter_clockwise(int t, std::size_t frame) const;

  GrowingMesh mesh_;
  const Triangles& original_;
  std::vector<double> longest_of_origin_;  ///< edge by triangle of the drawing [length]
  std::vector<FrameMap> maps_;
  /// By the triangles of a mesh, which many frames share.
  std::map<const Triangles*, std::shared_ptr<const RestCover>> covers_;
  std::vector<std::vector<Vec2>> deformed_;  ///< by frame, by vertex
  std::set<int> unsettled_;                  ///< triangles that may have to be mended
};

}  // namespace foldless
