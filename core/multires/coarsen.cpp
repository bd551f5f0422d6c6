// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/multires/coarsen.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace foldless {
namespace {

using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

/// 4√3 area over the sum of the squared sides, 1 for an equilateral triangle, below which no
/// collapse may bring a triangle.
constexpr double kLeastRoundness = 0.25;
/// A pass that takes less than this part of the vertices is the last.
constexpr double kLeastGainOfAPass = 0.01;

double roundness(const Points& points, int a, int b, int c) {
  const Vec2 p = points.col(a), q = points.col(b), r = points.col(c);
  const double sides = (q - p).squaredNorm() + (r - q).squaredNorm() + (p - r).squaredNorm();
  return 4 * std::sqrt(3.0) * signed_area(p, q, r) / sides;
}

/// The connectivity while vertices go.
class Coarsening {
 public:
  Coarsening(const MeshPair& mesh, const std::vector<int>& kept)
      : mesh_(mesh), may_go_(static_cast<std::size_t>(mesh.vertex_count()), true) {
    connectivity_.request_vertex_status();
    connectivity_.request_edge_status();
    connectivity_.request_halfedge_status();
    connectivity_.request_face_status();
    for (int v = 0; v < mesh.vertex_count(); ++v) connectivity_.add_vertex();
    for (const auto& t : mesh.triangles().colwise())
      connectivity_.add_face(VertexHandle(t[0]), VertexHandle(t[1]), VertexHandle(t[2]));
    for (const int v : kept) may_go_[static_cast<std::size_t>(v)] = false;
    for (int v = 0; v < mesh.vertex_count(); ++v)
      if (mesh.is_boundary_vertex(v) || mesh.is_isolated(v))
        may_go_[static_cast<std::size_t>(v)] = false;
  }

  /// Vertices that are no neighbours of each other go; returns how many, at most `most`.
  int pass(int most) {
    std::vector<bool> is_locked(may_go_.size(), false);
    int gone = 0;
    for (int v = 0; v < static_cast<int>(may_go_.size()) && gone < most; ++v) {
      const auto i = static_cast<std::size_t>(v);
      if (!may_go_[i] || is_locked[i]) continue;
      const HalfedgeHandle h = best_collapse(VertexHandle(v));
      if (!h.is_valid()) continue;
      for (auto other = connectivity_.cvv_iter(VertexHandle(v)); other.is_valid(); ++other)
        is_locked[static_cast<std::size_t>(other->idx())] = true;
      connectivity_.collapse(h);
      may_go_[i] = false;
      ++gone;
    }
    return gone;
  }

  CoarseMesh result() const {
    std::vector<int> vertices;
    std::vector<int> new_index(may_go_.size(), -1);
    for (int v = 0; v < mesh_.vertex_count(); ++v) {
      if (connectivity_.status(VertexHandle(v)).deleted()) continue;
      new_index[static_cast<std::size_t>(v)] = static_cast<int>(vertices.size());
      vertices.push_back(v);
    }
    Triangles triangles(3, mesh_.face_count());
    Eigen::Index count = 0;
    for (const auto face : connectivity_.faces()) {
      Eigen::Index corner = 0;
      for (const auto v : face.vertices())
        triangles(corner++, count) = new_index[static_cast<std::size_t>(v.idx())];
      ++count;
    }
    MeshPair coarse(triangles.leftCols(count), mesh_.rest()(Eigen::all, vertices),
                    mesh_.deformed()(Eigen::all, vertices));
    coarse.set_stiffness(mesh_.stiffness());
    return {std::move(coarse), vertices};
  }

 private:
  /// The collapse that leaves the roundest triangles, or none.
  HalfedgeHandle best_collapse(VertexHandle v) {
    HalfedgeHandle best;
    double best_roundness = kLeastRoundness;
    for (auto h = connectivity_.cvoh_iter(v); h.is_valid(); ++h) {
      const double worst = worst_roundness(v, connectivity_.to_vertex_handle(*h), best_roundness);
      if (worst <= best_roundness || !connectivity_.is_collapse_ok(*h)) continue;
      best = *h;
      best_roundness = worst;
    }
    return best;
  }

  /// Of the triangles round v when v has gone to `to`; 0 when it is not more than `least`.
  double worst_roundness(VertexHandle v, VertexHandle to, double least) const {
    double worst = 1;
    for (auto h = connectivity_.cvoh_ccwiter(v); h.is_valid(); ++h) {
      const int a = connectivity_.to_vertex_handle(*h).idx();
      const int b = connectivity_.to_vertex_handle(connectivity_.next_halfedge_handle(*h)).idx();
      if (a == to.idx() || b == to.idx()) continue;
      worst = std::min(worst, roundness(mesh_.rest(), to.idx(), a, b));
      if (worst <= least) return 0;
    }
    return worst;
  }

  const MeshPair& mesh_;
  std::vector<bool> may_go_;
  OpenMesh::TriConnectivity connectivity_;
};

}  // namespace

CoarseMesh coarsened(const MeshPair& mesh, const std::vector<int>& kept, int goal,
                     const std::stop_token& token) {
  Coarsening coarsening(mesh, kept);
  int left = mesh.vertex_count();
  while (left > goal && !token.stop_requested()) {
    const int gone = coarsening.pass(left - goal);
    left -= gone;
    if (gone < kLeastGainOfAPass * left) break;
  }
  return coarsening.result();
}

}  // namespace foldless
