// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remesh/flip_edges.h"

#include <numeric>
#include <vector>

#include "core/energy/element_loops.h"
#include "core/remesh/diamond_energy.h"
#include "core/remesh/edge_heap.h"
#include "core/threads/team.h"

namespace foldless {
namespace {

/// Without an absolute floor the rest state would flip on rounding noise.
constexpr double kLeastGain = 1e-10;

/// Triangles or edges that a thread takes together: some tens of microseconds.
constexpr std::ptrdiff_t kTogether = 512;

/// Triangles on the vertices of a mesh whose energies are found several at once.
class TriangleBatch {
 public:
  static constexpr int kMost = 128;

  TriangleBatch(const MeshPair& mesh, const EnergySettings& settings)
      : mesh_(mesh), settings_(settings), triangles_(3, kMost), rest_(kMost), energies_(kMost) {}

  int count() const { return count_; }
  /// Precondition: count() < kMost.
  void add(const Eigen::Vector3i& triangle) {
    triangles_.col(count_) = triangle;
    rest_[static_cast<std::size_t>(count_++)] = rest_element(mesh_, triangle);
  }
  double rest_area(int i) const { return rest_[static_cast<std::size_t>(i)].area; }
  /// Finds the energies of those that were added, and begins anew.
  void evaluate() {
    element_loops(settings_.density->kind)
        .energies({settings_, triangles_, rest_, mesh_.deformed()}, 0, count_,
                  {energies_.data(), nullptr, nullptr});
    count_ = 0;
  }
  /// Of the triangle that was added as the i-th before evaluate().
  double energy(int i) const { return energies_[static_cast<std::size_t>(i)].total(); }

 private:
  const MeshPair& mesh_;
  const EnergySettings& settings_;
  int count_ = 0;
  Triangles triangles_;
  std::vector<RestElement> rest_;
  std::vector<ElementEnergy> energies_;
};

/// E of every triangle of the mesh, so that each is evaluated once and not once an edge.
std::vector<double> triangle_energies(const MeshPair& mesh, const EnergySettings& settings) {
  std::vector<double> energies(static_cast<std::size_t>(mesh.face_count()));
  in_ranges(mesh.face_count(), kTogether, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    TriangleBatch batch(mesh, settings);
    for (std::ptrdiff_t f = begin; f < end;) {
      const std::ptrdiff_t first = f;
      for (; f < end && batch.count() < TriangleBatch::kMost; ++f)
        batch.add(mesh.triangles().col(f));
      batch.evaluate();
      for (std::ptrdiff_t t = first; t < f; ++t)
        energies[static_cast<std::size_t>(t)] = batch.energy(static_cast<int>(t - first));
    }
  });
  return energies;
}

/// The barrier of a diamond of that rest area, but for the factor χ.
double barrier_scale(const EnergySettings& energy, double area) {
  return energy.barrier_area_weighted ? energy.beta * area : energy.beta;
}

/// Δ_ab of some edges, where they are worth a flip.
class FlipGains {
 public:
  /// `energies` are those of the triangles.
  FlipGains(const MeshPair& mesh, const std::vector<double>& energies, const FlipSettings& settings)
      : mesh_(mesh), energies_(energies), settings_(settings), batch_(mesh, settings.energy) {}

  /// Writes the gains of edges begin ≤ e < end that may be flipped and are worth it to `gains`.
  void find(std::ptrdiff_t begin, std::ptrdiff_t end, std::vector<double>& gains) {
    for (std::ptrdiff_t e = begin; e < end; ++e) {
      consider(static_cast<int>(e));
      if (batch_.count() == TriangleBatch::kMost) decide(gains);
    }
    decide(gains);
  }

 private:
  void consider(int e) {
    if (mesh_.is_boundary_edge(e)) return;
    const Diamond diamond = mesh_.diamond(e);
    const double energy = energies_[static_cast<std::size_t>(diamond.left)] +
                          energies_[static_cast<std::size_t>(diamond.right)];
    // A gain is at most the energy itself: most of an undeformed mesh ends here.
    if (energy <= kLeastGain * barrier_scale(settings_.energy, 0)) return;
    const TrianglePair flipped = flipped_triangles_of(diamond);
    if (!is_feasible(mesh_, flipped, settings_.energy.delta)) return;
    for (const Eigen::Vector3i& t : flipped) batch_.add(t);
    edges_.push_back({e, energy});
  }

  /// Of the edges that were considered since the last time.
  void decide(std::vector<double>& gains) {
    batch_.evaluate();
    int i = 0;
    for (const auto& [e, energy] : edges_) {
      const double gain = energy - (batch_.energy(i) + batch_.energy(i + 1));
      const double area = batch_.rest_area(i) + batch_.rest_area(i + 1);
      i += 2;
      const double least = kLeastGain * (area + barrier_scale(settings_.energy, area));
      if (gain > settings_.eta * energy && gain > least && mesh_.is_flip_legal(e))
        gains[static_cast<std::size_t>(e)] = gain;
    }
    edges_.clear();
  }

  /// With the energy of its diamond, E_ab.
  struct Considered {
    int edge;
    double energy;
  };

  const MeshPair& mesh_;
  const std::vector<double>& energies_;
  const FlipSettings& settings_;
  TriangleBatch batch_;            ///< both flipped triangles of every edge
  std::vector<Considered> edges_;  ///< that may be flipped
};

/// The edges that are worth a flip; none where all of them gain too little.
EdgeHeap gains(const MeshPair& mesh, const FlipSettings& settings) {
  const std::vector<double> energies = triangle_energies(mesh, settings.energy);
  std::vector<double> of_edges(static_cast<std::size_t>(mesh.edge_count()));
  in_ranges(mesh.edge_count(), kTogether, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    FlipGains(mesh, energies, settings).find(begin, end, of_edges);
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
