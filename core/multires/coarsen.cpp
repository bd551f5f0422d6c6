// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/multires/coarsen.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/multires/corner_mesh.h"

namespace foldless {
namespace {

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

/// The vertices that go, one after the other.
class Coarsening {
 public:
  Coarsening(const MeshPair& mesh, const std::vector<int>& kept)
      : mesh_(mesh),
        may_go_(static_cast<std::size_t>(mesh.vertex_count()), true),
        corners_(mesh.triangles(), mesh.vertex_count()) {
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
      const int h = best_collapse(v);
      if (h == kNone) continue;
      for_round(v, [&](int out) {
        is_locked[static_cast<std::size_t>(corners_.to(out))] = true;
        return true;
      });
      corners_.collapse(h);
      may_go_[i] = false;
      ++gone;
    }
    return gone;
  }

  CoarseMesh result() const {
    std::vector<int> vertices;
    std::vector<int> new_index(may_go_.size(), kNone);
    for (int v = 0; v < mesh_.vertex_count(); ++v) {
      if (corners_.is_gone(v)) continue;
      new_index[static_cast<std::size_t>(v)] = static_cast<int>(vertices.size());
      vertices.push_back(v);
    }
    Triangles triangles(3, mesh_.face_count());
    Eigen::Index count = 0;
    for (int t = 0; t < corners_.face_count(); ++t) {
      if (corners_.is_face_gone(t)) continue;
      for (int corner = 0; corner < 3; ++corner)
        triangles(corner, count) =
            new_index[static_cast<std::size_t>(corners_.from(3 * t + corner))];
      ++count;
    }
    MeshPair coarse(triangles.leftCols(count), mesh_.rest()(Eigen::all, vertices),
                    mesh_.deformed()(Eigen::all, vertices));
    coarse.set_stiffness(mesh_.stiffness());
    return {std::move(coarse), vertices};
  }

 private:
  static constexpr int kNone = -1;

  /// Calls visit(half-edge) for those from an interior vertex until it returns false.
  template <class Visit>
  void for_round(int v, const Visit& visit) const {
    const int first = corners_.outgoing(v);
    int h = first;
    do {
      if (!visit(h)) return;
      h = corners_.clockwise(h);
    } while (h != first);
  }

  /// The collapse that leaves the roundest triangles, or none.
  int best_collapse(int v) {
    int best = kNone;
    double best_roundness = kLeastRoundness;
    for_round(v, [&](int h) {
      const double worst = worst_roundness(v, corners_.to(h), best_roundness);
      if (worst > best_roundness && corners_.may_collapse(h)) {
        best = h;
        best_roundness = worst;
      }
      return true;
    });
    return best;
  }

  /// Of the triangles round v when v has gone to `to`; 0 when it is not more than `least`.
  double worst_roundness(int v, int to, double least) const {
    double worst = 1;
    for_round(v, [&](int h) {
      const int a = corners_.to(h), b = corners_.to(CornerMesh::next(h));
      if (a == to || b == to) return true;
      worst = std::min(worst, roundness(mesh_.rest(), to, a, b));
      return worst > least;
    });
    return worst > least ? worst : 0;
  }

  const MeshPair& mesh_;
  std::vector<bool> may_go_;
  CornerMesh corners_;
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
