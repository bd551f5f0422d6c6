// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/coarse_hessian.h"

#include <cmath>
#include <cstddef>
#include <utility>

#include "core/mesh/triangle.h"
#include "core/threads/team.h"

namespace foldless {
namespace coarse_hessians {

/// Vertices that a thread places together.
constexpr std::ptrdiff_t kPlacedTogether = 4096;
/// Rounding gives vertices that both meshes have a little of their neighbours.
constexpr double kNoWeight = 1e-12;

/// Barycentric coordinates of a point at rest.
Interpolation::Place place_in(const MeshPair& mesh, int triangle, const Vec2& p) {
  const Eigen::Vector3i corners = mesh.triangles().col(triangle);
  const Corners x = corners_of(mesh.rest(), corners);
  const double area = signed_area(x.col(0), x.col(1), x.col(2));
  Interpolation::Place place;
  for (int k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(k);
    place.nodes[i] = corners[k];
    const double weight = signed_area(p, x.col((k + 1) % 3), x.col((k + 2) % 3)) / area;
    place.weights[i] = std::abs(weight) > kNoWeight ? weight : 0;
  }
  return place;
}

}  // namespace coarse_hessians

std::optional<CoarseHessian> coarse_hessian(Workspace& coarse, const std::vector<int>& holding,
                                            const MeshPair& fine) {
  using namespace coarse_hessians;
  const std::vector<bool> is_held =
      have_hard_handles(coarse.constraints, coarse.mesh.vertex_count());
  std::vector<Interpolation::Place> places(holding.size());
  each_in_ranges(std::ssize(holding), kPlacedTogether, [&](std::ptrdiff_t v) {
    const auto i = static_cast<std::size_t>(v);
    if (holding[i] < 0) return;
    places[i] = place_in(coarse.mesh, holding[i], fine.rest().col(v));
    for (std::size_t k = 0; k < 3; ++k)
      if (is_held[static_cast<std::size_t>(places[i].nodes[k])]) places[i].weights[k] = 0;
  });
  return coarse.system.factor().as_coarse(
      Interpolation(std::move(places), coarse.mesh.vertex_count()), coarse.system.take_hessian());
}

}  // namespace foldless
