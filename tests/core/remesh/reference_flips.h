// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include "core/mesh/injective.h"
#include "core/remesh/flip_edges.h"
#include "tests/support/random_scene.h"
#include "tests/support/random_vector.h"

namespace foldless::test {

/// Distortion and barrier of a triangle under ARAP by its singular values.
inline double arap_energy(const Corners& rest, const Corners& deformed,
                          const EnergySettings& settings) {
  Mat2 r, d;
  r << rest.col(1) - rest.col(0), rest.col(2) - rest.col(0);
  d << deformed.col(1) - deformed.col(0), deformed.col(2) - deformed.col(0);
  const Mat2 J = d * r.inverse();
  const double area = r.determinant() / 2, det = J.determinant();
  const double x = (det - settings.delta) / (1 - settings.delta);
  if (!(x > 0)) return std::numeric_limits<double>::infinity();
  const Vec2 sigma = Eigen::JacobiSVD<Mat2>(J).singularValues();
  const double barrier = x < 1 ? 1 / (1 - std::pow(1 - x, 3)) - 1 : 0;
  return (settings.area_weighted ? area : settings.unit_area) * (sigma.array() - 1).square().sum() /
             2 +
         settings.beta * (settings.barrier_area_weighted ? area : 1) * barrier;
}

/// The same of the triangles (p, q, r) and (s, t, u) of a mesh, with other deformed positions.
inline double pair_energy(const MeshPair& mesh, const Points& u, const std::array<int, 6>& corners,
                          const EnergySettings& settings) {
  const std::vector<int> first(corners.begin(), corners.begin() + 3);
  const std::vector<int> second(corners.begin() + 3, corners.end());
  double sum = 0;
  for (const auto& t : {first, second})
    sum += arap_energy(mesh.rest()(Eigen::all, t), u(Eigen::all, t), settings);
  return sum;
}

/// An edge with its two tessellations.
struct FlipCandidate {
  int edge;
  std::array<int, 6> now, flipped;
  double energy = 0, gain = 0;  ///< E_ab and Δ_ab
};

/// ‖∇E‖_∞ / E by central differences.
inline double condition(const MeshPair& mesh, const std::array<int, 6>& corners,
                        const EnergySettings& settings) {
  double largest = 0;
  for (const int v : corners)
    for (const int coordinate : {0, 1}) {
      const auto at = [&](double offset) {
        Points u = mesh.deformed();
        u(coordinate, v) += offset;
        return pair_energy(mesh, u, corners, settings);
      };
      constexpr double h = 1e-6;
      largest =
          std::max(largest, std::abs(8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h));
    }
  return largest / pair_energy(mesh, mesh.deformed(), corners, settings);
}

inline FlipCandidate flip_candidate(const MeshPair& mesh, int e, const EnergySettings& settings) {
  const Diamond q = mesh.diamond(e);
  FlipCandidate result{e, {q.a, q.b, q.c, q.b, q.a, q.d}, {q.a, q.d, q.c, q.d, q.b, q.c}};
  result.energy = pair_energy(mesh, mesh.deformed(), result.now, settings);
  result.gain = result.energy - pair_energy(mesh, mesh.deformed(), result.flipped, settings);
  return result;
}

/// Rules of 4.3 that may be left out, to see what they are for.
struct FlipRules {
  bool descending = true;
  bool drops_neighbours = true;
  bool condition = true;
  bool reversed_condition = false;
  bool eta = true;
};

/// FlipEdges by the letter of 4.3, with a list that is searched from end to end. Returns the
/// number of flips.
inline int reference_flips(MeshPair& mesh, const FlipSettings& settings,
                           const FlipRules& rules = {}) {
  std::vector<FlipCandidate> candidates;
  for (int e = 0; e < mesh.edge_count(); ++e) {
    if (mesh.is_boundary_edge(e)) continue;
    const FlipCandidate c = flip_candidate(mesh, e, settings.energy);
    const auto is_open = [&](const Points& points, int first) {
      return signed_area(points, Eigen::Vector3i(c.flipped.data() + first)) > 1e-6;
    };
    if (!is_open(mesh.rest(), 0) || !is_open(mesh.rest(), 3)) continue;
    if (c.gain > std::max(1e-9, rules.eta ? settings.eta * c.energy : 0)) candidates.push_back(c);
  }
  int flips = 0;
  while (!candidates.empty()) {
    const auto next = rules.descending
                          ? std::ranges::max_element(candidates, {}, &FlipCandidate::gain)
                          : std::ranges::min_element(candidates, {}, &FlipCandidate::gain);
    const FlipCandidate c = *next;
    candidates.erase(next);
    if (!mesh.is_flip_legal(c.edge)) continue;
    const double now = condition(mesh, c.now, settings.energy);
    const double then = condition(mesh, c.flipped, settings.energy);
    if (rules.condition && (rules.reversed_condition ? then < now : then > now)) continue;
    mesh.flip(c.edge);
    ++flips;
    if (rules.drops_neighbours)
      std::erase_if(candidates, [&](const FlipCandidate& other) {
        const Edge edge = mesh.edge(other.edge);
        return std::ranges::all_of(edge, [&](int v) { return std::ranges::count(c.now, v) > 0; });
      });
  }
  return flips;
}

/// A random mesh whose vertices moved one by one, as far as no triangle has less than a twentieth
/// of its area.
inline MeshPair tangled_pair(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(-0.15, 0.15);
  const Shape shape = random_shape(random);
  MeshPair mesh(shape.triangles, shape.rest);
  for (int pass = 0; pass < 3; ++pass)
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      Points u = mesh.deformed();
      u.col(v) += random_vector(unit, random);
      const bool is_open = std::ranges::all_of(mesh.triangles_of_vertex(v), [&](int t) {
        const Eigen::Vector3i corners = mesh.triangles().col(t);
        return signed_area(u, corners) > 0.05 * signed_area(mesh.rest(), corners);
      });
      if (is_open && is_injective(mesh.triangles(), u)) mesh.set_deformed(u);
    }
  return mesh;
}

}  // namespace foldless::test
