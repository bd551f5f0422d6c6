// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remesh/flip_edges.h"

#include <numeric>
#include <vector>

#include "core/remesh/diamond_energy.h"
#include "core/remesh/edge_heap.h"
#include "core/threads/team.h"

namespace foldless {
namespace {

/// Without an absolute floor the rest state would flip on rounding noise.
constexpr double kLeastGain = 1e-10;

/// Triangles or edges that a thread takes together: some tens of microseconds.
constexpr std::ptrdiff_t kTogether = 512;

/// E of every triangle of the mesh, so that each is evaluated once and not once an edge.
std::vector<double> triangle_energies(const MeshPair& mesh, const EnergySettings& settings) {
  std::vector<double> energies(static_cast<std::size_t>(mesh.face_count()));
  each_in_ranges(mesh.face_count(), kTogether, [&](std::ptrdiff_t f) {
    const Eigen::Vector3i t = mesh.triangles().col(f);
    energies[static_cast<std::size_t>(f)] =
        element_energy(settings, reference_element(settings, mesh, t),
                       corners_of(mesh.deformed(), t))
            .total();
  });
  return energies;
}

/// The barrier of a diamond of that rest area, but for the factor χ.
double barrier_scale(const EnergySettings& energy, double area) {
  return energy.barrier_area_weighted ? energy.beta * area : energy.beta;
}

/// Δ_ab when it is worth a flip, else 0. `energy` is E_ab.
double gain_of_flip(const MeshPair& mesh, const Diamond& diamond, double energy,
                    const FlipSettings& settings) {
  const TrianglePair flipped = flipped_triangles_of(diamond);
  if (!is_feasible(mesh, flipped, settings.energy.delta)) return 0;
  const double gain = energy - energy_of(mesh, flipped, settings.energy);
  double area = 0;
  for (const Eigen::Vector3i& t : flipped) area += signed_area(mesh.rest(), t);
  const double least = kLeastGain * (area + barrier_scale(settings.energy, area));
  return gain > settings.eta * energy && gain > least ? gain : 0;
}

/// Δ_ab of an edge that may be flipped and is worth it, else 0; `energies` are those of the
/// triangles.
double gain_at(int e, const MeshPair& mesh, const std::vector<double>& energies,
               const FlipSettings& settings) {
  if (mesh.is_boundary_edge(e)) return 0;
  const Diamond diamond = mesh.diamond(e);
  const double energy = energies[static_cast<std::size_t>(diamond.left)] +
                        energies[static_cast<std::size_t>(diamond.right)];
  // A gain is at most the energy itself: most of an undeformed mesh ends here.
  if (energy <= kLeastGain * barrier_scale(settings.energy, 0)) return 0;
  const double gain = gain_of_flip(mesh, diamond, energy, settings);
  return gain > 0 && mesh.is_flip_legal(e) ? gain : 0;
}

/// The edges that are worth a flip; none where all of them gain too little.
EdgeHeap gains(const MeshPair& mesh, const FlipSettings& settings) {
  const std::vector<double> energies = triangle_energies(mesh, settings.energy);
  std::vector<double> of_edges(static_cast<std::size_t>(mesh.edge_count()));
  each_in_ranges(mesh.edge_count(), kTogether, [&](std::ptrdiff_t e) {
    of_edges[static_cast<std::size_t>(e)] = gain_at(static_cast<int>(e), mesh, energies, settings);
  });
  EdgeHeap heap(mesh.edge_count());
  double total = 0;
  for (int e = 0; e < mesh.edge_count(); ++e)
    if (const double gain = of_edges[static_cast<std::size_t>(e)]; gain > 0) {
      heap.push(e, gain);
      total += gain;
    }
  const double energy = std::accumulate(energies.begin(), energies.end(), 0.0);
  return total < settings.least_total_gain * energy ? EdgeHeap(0) : heap;
}

bool raises_condition(const MeshPair& mesh, const Diamond& diamond,
                      const EnergySettings& settings) {
  return condition_of(mesh, flipped_triangles_of(diamond), diamond, settings) >
         condition_of(mesh, triangles_of(diamond), diamond, settings);
}

}  // namespace

int flip_edges(MeshPair& mesh, const FlipSettings& settings) {
  EdgeHeap heap = gains(mesh, settings);
  int flips = 0;
  while (const std::optional<int> e = heap.pop()) {
    // The diamond is as it was when pushed, but an edge c–d may have been made elsewhere since.
    if (!mesh.is_flip_legal(*e)) continue;
    const Diamond diamond = mesh.diamond(*e);
    if (settings.condition_test && raises_condition(mesh, diamond, settings.energy)) continue;
    mesh.flip(*e);
    ++flips;
    for (const int t : {diamond.left, diamond.right})
      for (const int side : mesh.edges_of_triangle(t)) heap.erase(side);
  }
  return flips;
}

}  // namespace foldless
