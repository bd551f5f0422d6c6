// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/go_back.h"

#include <utility>

#include "core/mesh/injective.h"
#include "core/method/foldless/settle.h"

namespace foldless {
namespace going_back {

/// What the original triangulation may cost, of E Kᵉ,
constexpr double kRise = 1e-2;
/// and where a map is next to none, of its energy a unit of area.
constexpr double kNoEnergy = 1e-12;
/// Barycentric distance from an edge below which a point lies on it.
constexpr double kOnEdge = 1e-9;

struct Place {
  int triangle = 0;
  Eigen::Vector3d barycentric = Eigen::Vector3d::Constant(-1);
};

/// Splits leave rest positions inside their old triangle up to rounding, so the triangle in which
/// the smallest coordinate is largest holds the point.
Place place_at_rest(const MeshPair& mesh, const Vec2& p) {
  Place best;
  for (int t = 0; t < mesh.face_count(); ++t) {
    const Eigen::Vector3i v = mesh.triangles().col(t);
    const Vec2 a = mesh.rest().col(v[0]), b = mesh.rest().col(v[1]), c = mesh.rest().col(v[2]);
    const Eigen::Vector3d coordinates =
        Eigen::Vector3d(signed_area(p, b, c), signed_area(a, p, c), signed_area(a, b, p)) /
        signed_area(a, b, c);
    if (coordinates.minCoeff() > best.barycentric.minCoeff()) best = {t, coordinates};
  }
  return best;
}

/// False at a corner.
bool insert_at_rest(MeshPair& mesh, const Vec2& p) {
  const Place place = place_at_rest(mesh, p);
  Eigen::Index opposite = 0;
  if (place.barycentric.minCoeff(&opposite) >= kOnEdge) {
    mesh.split_triangle(place.triangle, place.barycentric);
    return true;
  }
  const Eigen::Vector3i corners = mesh.triangles().col(place.triangle);
  const Eigen::Index from = (opposite + 1) % 3, to = (opposite + 2) % 3;
  const double t = place.barycentric[to] / (place.barycentric[from] + place.barycentric[to]);
  if (!(t >= kOnEdge && t <= 1 - kOnEdge)) return false;
  const int e = *mesh.find_edge(corners[from], corners[to]);
  mesh.split_edge(e, mesh.edge(e)[0] == corners[from] ? t : 1 - t);
  return true;
}

double area_at_rest(const MeshPair& mesh) {
  double area = 0;
  for (const auto& t : mesh.triangles().colwise()) area += signed_area(mesh.rest(), t);
  return area;
}

bool is_no_worse(const Workspace& work, const Workspace& other) {
  return merit_of(work) <= (1 + kRise) * merit_of(other) ||
         settled_energy(work) <= kNoEnergy * area_at_rest(work.mesh);
}

}  // namespace going_back

std::optional<Triangles> original_triangles(const Problem& problem, int vertices) {
  const Points rest = problem.mesh.rest().leftCols(vertices);
  if (!problem.original) {
    if (vertices < problem.mesh.vertex_count()) return std::nullopt;
    return problem.mesh.triangles();
  }
  const auto& [triangles, count] = *problem.original;
  if (triangles->maxCoeff() >= count || count > vertices) return std::nullopt;
  MeshPair mesh(*triangles, rest.leftCols(count));
  for (int v = count; v < vertices; ++v)
    if (!going_back::insert_at_rest(mesh, rest.col(v))) return std::nullopt;
  if (!is_injective(mesh.triangles(), rest)) return std::nullopt;
  return mesh.triangles();
}

Steps<> go_back(Workspace& work, const Triangles& original) {
  const Eigen::Index vertices = original.maxCoeff() + 1;
  const bool is_there =
      work.mesh.triangles().cols() == original.cols() && work.mesh.triangles() == original;
  if (is_there || vertices > work.mesh.vertex_count()) co_return;
  MeshPair mesh(original, work.mesh.rest().leftCols(vertices),
                work.mesh.deformed().leftCols(vertices));
  if (!is_injective(mesh.triangles(), mesh.rest(), mesh.deformed())) co_return;
  Workspace other = work;
  other.set_mesh(std::move(mesh));
  if (!other.is_feasible()) co_return;
  co_await settle(other);
  if (going_back::is_no_worse(other, work)) work = std::move(other);
  co_yield [&work](Iteration& last) { work.measure_again(last, work.held_energy()); };
}

}  // namespace foldless
