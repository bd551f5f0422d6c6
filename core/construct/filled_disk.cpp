// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/filled_disk.h"

#include <algorithm>
#include <utility>

#include "core/construct/delaunay.h"
#include "core/mesh/injective.h"
#include "core/multires/holding_triangles.h"

namespace foldless {
namespace {

/// A vertex that is nearer to a side than this part of a triangle counts as on it: chords often go
/// through vertices but for rounding.
constexpr double kLeastBarycentric = 1e-6;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// The vertices of a mesh within the triangles of a coarser one over the same disk, connected.
class FilledDisk {
 public:
  FilledDisk(const MeshPair& mesh, const std::vector<int>& corners, const MeshPair& coarse)
      : mesh_(mesh),
        coarse_(coarse),
        within_(at(coarse.face_count())),
        index_(corners),
        holding_(holding_triangles({coarse, corners}, mesh)),
        deformed_(mesh.deformed()) {
    index_.resize(at(coarse.vertex_count()), kNone);
    deformed_(Eigen::all, corners) = coarse.deformed().leftCols(count(corners));
    std::vector<bool> is_corner(holding_.size(), false);
    for (const int v : corners) is_corner[at(v)] = true;
    for (int v = 0; v < mesh.vertex_count(); ++v)
      if (holding_[at(v)] >= 0 && !is_corner[at(v)] && !place(v, holding_[at(v)]))
        has_failed_ = true;
  }

  std::optional<MeshPair> filled() {
    if (has_failed_) return std::nullopt;
    const std::vector<int> crossings = number_crossings();
    Points rest(2, mesh_.vertex_count() + static_cast<int>(crossings.size()));
    rest << mesh_.rest(), coarse_.rest()(Eigen::all, crossings);
    Points deformed(2, rest.cols());
    deformed << deformed_, coarse_.deformed()(Eigen::all, crossings);
    const std::optional<Triangles> triangles = triangles_over(rest);
    if (!triangles || !is_injective(*triangles, rest, deformed)) return std::nullopt;
    return MeshPair(*triangles, std::move(rest), std::move(deformed));
  }

 private:
  static constexpr int kNone = -1;

  /// A vertex in a triangle of the coarse mesh.
  struct Place {
    int vertex;
    int sides;  ///< bits: the sides that it is on, by the corner opposite
  };

  static int count(const std::vector<int>& corners) { return static_cast<int>(corners.size()); }

  /// False where two vertices are at one crossing, or one is at a corner.
  bool place(int v, int t) {
    const Eigen::Vector3i corners = coarse_.triangles().col(t);
    Eigen::Vector3d barycentric = barycentric_of(coarse_.rest(), corners, mesh_.rest().col(v));
    std::vector<int> off_sides;
    for (int i = 0; i < 3; ++i) {
      if (barycentric[i] >= kLeastBarycentric || is_boundary_side(corners, i))
        off_sides.push_back(i);
      barycentric[i] = std::max(barycentric[i], kLeastBarycentric);
    }
    if (off_sides.size() < 2) return place_at_crossing(v, corners[off_sides.front()]);
    const int on_side = 3 - off_sides[0] - off_sides[1];  // of the three, where it is on one
    if (off_sides.size() == 2) {
      barycentric[on_side] = 0;
      add_on_side(v, corners, on_side);
    } else {
      within_[at(t)].push_back({v, 0});
    }
    deformed_.col(v) = coarse_.deformed()(Eigen::all, corners) * barycentric / barycentric.sum();
    return true;
  }

  /// The side is that opposite of a corner.
  int side(const Eigen::Vector3i& corners, int opposite) const {
    return coarse_.find_edge(corners[(opposite + 1) % 3], corners[(opposite + 2) % 3]).value();
  }
  bool is_boundary_side(const Eigen::Vector3i& corners, int opposite) const {
    return coarse_.is_boundary_edge(side(corners, opposite));
  }

  bool place_at_crossing(int v, int crossing) {
    if (index_[at(crossing)] != kNone) return false;
    index_[at(crossing)] = v;
    deformed_.col(v) = coarse_.deformed().col(crossing);
    return true;
  }

  /// A vertex on a side belongs to the triangles on both sides of it.
  void add_on_side(int v, const Eigen::Vector3i& of_triangle, int opposite) {
    const int edge = side(of_triangle, opposite);
    for (const int t : coarse_.triangles_of_edge(edge)) {
      const Eigen::Vector3i corners = coarse_.triangles().col(t);
      for (int i = 0; i < 3; ++i)
        if (side(corners, i) == edge) within_[at(t)].push_back({v, 1 << i});
    }
  }

  /// Those at which there is no vertex become the last vertices.
  std::vector<int> number_crossings() {
    std::vector<int> crossings;
    for (int i = 0; i < coarse_.vertex_count(); ++i) {
      if (index_[at(i)] != kNone) continue;
      index_[at(i)] = mesh_.vertex_count() + static_cast<int>(crossings.size());
      crossings.push_back(i);
    }
    return crossings;
  }

  /// Those of other components and those within each triangle of the coarse mesh.
  std::optional<Triangles> triangles_over(const Points& rest) const {
    std::vector<Eigen::Vector3i> triangles;
    for (const auto& t : mesh_.triangles().colwise())
      if (holding_[at(t[0])] < 0) triangles.emplace_back(t);
    for (int t = 0; t < coarse_.face_count(); ++t)
      if (!add_triangles_within(t, rest, triangles)) return std::nullopt;
    Triangles all(3, static_cast<Eigen::Index>(triangles.size()));
    for (std::size_t t = 0; t < triangles.size(); ++t)
      all.col(static_cast<Eigen::Index>(t)) = triangles[t];
    return all;
  }

  /// Delaunay. Vertices on a side may bend it a little; triangles of such vertices alone are none.
  /// False where vertices coincide.
  bool add_triangles_within(int t, const Points& rest,
                            std::vector<Eigen::Vector3i>& triangles) const {
    std::vector<int> vertices, sides;  // as bits
    for (const Place& place : within_[at(t)]) {
      vertices.push_back(place.vertex);
      sides.push_back(place.sides);
    }
    for (int i = 0; i < 3; ++i) {
      vertices.push_back(index_[at(coarse_.triangles()(i, t))]);
      sides.push_back(7 - (1 << i));
    }
    const auto within = delaunay_triangles(rest(Eigen::all, vertices));
    if (!within) return false;
    for (const auto& corners : within->colwise())
      if ((sides[at(corners[0])] & sides[at(corners[1])] & sides[at(corners[2])]) == 0)
        triangles.emplace_back(corners.unaryExpr([&](int i) { return vertices[at(i)]; }));
    return true;
  }

  const MeshPair& mesh_;
  const MeshPair& coarse_;
  std::vector<std::vector<Place>> within_;  ///< by triangle of the coarse mesh
  std::vector<int> index_;    ///< of the vertices of the coarse mesh; kNone: not numbered yet
  std::vector<int> holding_;  ///< triangles of the coarse mesh; −1: of another component
  Points deformed_;           ///< of the vertices of the mesh
  bool has_failed_ = false;
};

}  // namespace

std::optional<MeshPair> filled(const MeshPair& coarse, const std::vector<int>& corners,
                               const MeshPair& mesh) {
  return FilledDisk(mesh, corners, coarse).filled();
}

}  // namespace foldless
