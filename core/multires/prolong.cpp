// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/multires/prolong.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "core/energy/shared_elements.h"
#include "core/mesh/injective.h"
#include "core/multires/holding_triangles.h"
#include "core/multires/insert_edge.h"
#include "core/multires/vertices_of_splits.h"

namespace foldless {
namespace {

/// Energy per area of a fine triangle over the most of those coarse ones that hold its corners, or
/// over the mean, from which it lies across edges that matter.
constexpr double kLargestRatio = 2;
/// Energy per area that is none: what rounding makes of the identity is less.
constexpr double kNoEnergy = 1e-6;
/// Vertices that are placed by one task.
constexpr std::ptrdiff_t kPlacedTogether = 4096;

double energy_per_area(const MeshPair& mesh, int t, const EnergySettings& energy) {
  const Eigen::Vector3i corners = mesh.triangles().col(t);
  const RestElement rest = reference_element(energy, mesh, corners);
  return element_energy(energy, rest, corners_of(mesh.deformed(), corners)).total() / rest.area;
}

/// True when a segment and a triangle have inner points in common.
bool is_across(const Corners& triangle, const Vec2& a, const Vec2& b) {
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  for (int corner = 0; corner < 3; ++corner) {
    const Vec2 p = triangle.col(corner), q = triangle.col((corner + 1) % 3);
    if (signed_area(p, q, a) <= 0 && signed_area(p, q, b) <= 0) return false;
    const double side = signed_area(a, b, p);
    least = std::min(least, side);
    greatest = std::max(greatest, side);
  }
  return least < 0 && greatest > 0;
}

class Prolongation {
 public:
  Prolongation(const CoarseMesh& coarse, const MeshPair& fine, const EnergySettings& energy)
      : coarse_(coarse),
        energy_(energy),
        holding_(holding_triangles(coarse, fine)),
        is_inserted_(static_cast<std::size_t>(coarse.mesh.edge_count()), false),
        result_{fine} {
    per_area_.resize(static_cast<std::size_t>(coarse.mesh.face_count()));
    for_triangles(coarse.mesh.face_count(), [&](std::ptrdiff_t t) {
      per_area_[static_cast<std::size_t>(t)] =
          energy_per_area(coarse.mesh, static_cast<int>(t), energy);
    });
    double sum = 0;
    int finite = 0;
    for (const double energy_of_one : per_area_) {
      if (!std::isfinite(energy_of_one)) continue;
      sum += energy_of_one;
      ++finite;
    }
    mean_ = std::max(kNoEnergy, sum / std::max(1, finite));
    result_.mesh.set_deformed(positions());
  }

  std::optional<ProlongedMesh> result(const std::stop_token& token) {
    if (token.stop_requested()) return std::nullopt;
    insert_edges();
    if (token.stop_requested()) return std::nullopt;
    if (is_valid()) return with_holding();
    const int vertices = result_.mesh.vertex_count();
    mend();
    if (!is_valid()) return std::nullopt;
    result_.splits = result_.mesh.vertex_count() - vertices;
    return with_holding();
  }

 private:
  ProlongedMesh with_holding() {
    result_.holding = std::move(holding_);
    return std::move(result_);
  }

  int holding(int v) const { return holding_[static_cast<std::size_t>(v)]; }

  Points positions() const {
    const MeshPair& fine = result_.mesh;
    Points u = fine.deformed();
    each_in_ranges(fine.vertex_count(), kPlacedTogether, [&](std::ptrdiff_t i) {
      const auto v = static_cast<int>(i);
      if (holding(v) >= 0) u.col(v) = place(fine.rest().col(v), holding(v));
    });
    for (std::size_t i = 0; i < coarse_.vertices.size(); ++i)
      u.col(coarse_.vertices[i]) = coarse_.mesh.deformed().col(static_cast<Eigen::Index>(i));
    return u;
  }

  Vec2 place(const Vec2& p, int triangle) const {
    const Eigen::Vector3i t = coarse_.mesh.triangles().col(triangle);
    const Mat2 map = deformation_gradient(coarse_.mesh.rest(), coarse_.mesh.deformed(), t);
    return coarse_.mesh.deformed().col(t[0]) + map * (p - coarse_.mesh.rest().col(t[0]));
  }

  /// Infinite only where a coarse triangle is outside of the feasible set, which may be in
  /// components that do not move.
  double largest_energy_per_area(int t) const {
    double largest = mean_;
    for (const int v : result_.mesh.triangles().col(t))
      largest = std::max(largest, per_area_[static_cast<std::size_t>(holding(v))]);
    return kLargestRatio * largest;
  }

  bool is_feasible(int t) const {
    return std::isfinite(energy_per_area(result_.mesh, t, energy_)) ||
           !std::isfinite(largest_energy_per_area(t));
  }

  bool is_valid() const {
    const MeshPair& mesh = result_.mesh;
    const auto is_open = [&](std::ptrdiff_t t) { return is_feasible(static_cast<int>(t)); };
    return all_triangles(mesh.face_count(), is_open) &&
           is_injective(mesh.triangles(), mesh.rest(), mesh.deformed());
  }

  // Flips make other triangles lie across other edges; none is inserted twice.
  void insert_edges() {
    for (std::vector<int> edges = edges_to_insert(); !edges.empty(); edges = edges_to_insert())
      for (const int e : edges) insert(e);
  }

  std::vector<int> triangles_that_lie_across() const {
    return triangles_where(result_.mesh.face_count(), [&](int t) {
      return energy_per_area(result_.mesh, t, energy_) > largest_energy_per_area(t);
    });
  }

  /// With those round boundary vertices that overlap themselves.
  std::vector<int> invalid_triangles() const {
    const MeshPair& mesh = result_.mesh;
    std::vector<int> triangles =
        triangles_where(mesh.face_count(), [&](int t) { return !is_feasible(t); });
    for (const int v : overlapping_boundary_vertices(mesh.triangles(), mesh.deformed()))
      std::ranges::copy(mesh.triangles_of_vertex(v), std::back_inserter(triangles));
    return triangles;
  }

  // Where the fine mesh folds all the same it gets the vertices of the splits that are near.
  void mend() {
    splits_.emplace(coarse_, result_.mesh);
    for (int e = 0; e < coarse_.mesh.edge_count(); ++e)
      if (coarse_.mesh.edge(e)[1] >= first_of_splits())
        is_inserted_[static_cast<std::size_t>(e)] = false;
    insert_edges();
  }

  int first_of_splits() const { return static_cast<int>(coarse_.vertices.size()); }

  /// The coarse edges that are not edges of the fine mesh but should be.
  std::vector<int> edges_to_insert() const {
    std::vector<int> edges;
    for (const int t : splits_ ? invalid_triangles() : triangles_that_lie_across())
      add_edges_across(t, edges);
    std::erase_if(edges, [&](int e) { return is_inserted_[static_cast<std::size_t>(e)]; });
    return edges;
  }

  /// The coarse edges that cross a fine triangle, from those round its corners on.
  void add_edges_across(int t, std::vector<int>& edges) const {
    const MeshPair& mesh = coarse_.mesh;
    const Eigen::Vector3i vertices = result_.mesh.triangles().col(t);
    const Corners corners = corners_of(result_.mesh.rest(), vertices);
    std::vector<int> seen;
    const auto see = [&](int triangle) {
      if (std::ranges::find(seen, triangle) == seen.end()) seen.push_back(triangle);
    };
    for (const int v : vertices)
      for (const int corner : mesh.triangles().col(holding(v)))
        for (const int triangle : mesh.triangles_of_vertex(corner)) see(triangle);
    for (std::size_t next = 0; next < seen.size(); ++next)
      for (const int e : mesh.edges_of_triangle(seen[next])) {
        const auto [a, b] = mesh.edge(e);
        if (!is_across(corners, mesh.rest().col(a), mesh.rest().col(b))) continue;
        edges.push_back(e);
        for (const int triangle : mesh.triangles_of_edge(e)) see(triangle);
      }
  }

  void insert(int e) {
    if (is_inserted_[static_cast<std::size_t>(e)]) return;
    is_inserted_[static_cast<std::size_t>(e)] = true;
    const auto [a, b] = coarse_.mesh.edge(e);
    const std::optional<int> from = fine_vertex(a), to = fine_vertex(b);
    if (from && to) result_.flips += insert_edge(result_.mesh, *from, *to);
  }

  /// Of a vertex of the coarse mesh.
  std::optional<int> fine_vertex(int v) {
    if (v < first_of_splits()) return coarse_.vertices[static_cast<std::size_t>(v)];
    if (!splits_) return std::nullopt;
    const int count = result_.mesh.vertex_count();
    const std::optional<int> vertex = splits_->vertex_at(v);
    if (result_.mesh.vertex_count() == count) return vertex;
    holding_.push_back(coarse_.mesh.triangles_of_vertex(v).front());
    Points u = result_.mesh.deformed();
    u.col(*vertex) = coarse_.mesh.deformed().col(v);
    result_.mesh.set_deformed(std::move(u));
    return vertex;
  }

  const CoarseMesh& coarse_;
  const EnergySettings& energy_;
  std::vector<int> holding_;      ///< the coarse triangle of every fine vertex
  std::vector<double> per_area_;  ///< energy of every coarse triangle over its rest area
  double mean_ = 0;
  std::vector<bool> is_inserted_;           ///< by coarse edge
  std::optional<VerticesOfSplits> splits_;  ///< once it is mended
  ProlongedMesh result_;
};

}  // namespace

std::optional<ProlongedMesh> prolonged(const CoarseMesh& coarse, const MeshPair& fine,
                                       const EnergySettings& energy, const std::stop_token& token) {
  return Prolongation(coarse, fine, energy).result(token);
}

}  // namespace foldless
