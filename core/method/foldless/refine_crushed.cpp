// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/refine_crushed.h"

#include <span>
#include <utility>

#include "core/method/foldless/candidates.h"
#include "core/method/foldless/settle.h"
#include "core/method/foldless/tidy.h"

namespace foldless {
namespace refining {

/// In which triangles edges are split in a round, and how the mesh settles after it.
struct Refinement {
  double part;  ///< of the largest σ₁/σ₂, from which on
  SettleSettings settings;
};
/// Each where those before it leave the mesh crushed. High powers see the worst triangles alone.
constexpr Refinement kGentle[] = {{0.7, {.exponent = 0.4}},
                                  {0.7, {.exponent = 0.4, .power = 16}},
                                  {0.2, {.exponent = 0.4, .power = 16}}};
/// Where a triangle is crushed, k is half of σ₁/σ₂.
constexpr double kEnough = 0.5 * kCrushed;
/// They lower the largest σ₁/σ₂ whatever that costs, but hardly further than to where no triangle
/// is crushed.
constexpr Refinement kForceful[] = {{0.7, {.exponent = 8, .power = 16, .enough = 1.3 * kEnough}},
                                    {0.7, {.exponent = 8, .power = 16, .enough = kEnough}},
                                    {0.2, {.exponent = 8, .power = 16, .enough = kEnough}}};
/// A pass refines the mesh and takes back what was not needed; the next one finds other triangles.
struct Passes {
  std::span<const Refinement> refinements;
  int most;
  double dearer;  ///< E is at most so many times that of the mesh before all passes
};
/// The second kind where the first leaves the mesh crushed.
constexpr Passes kPasses[] = {{kGentle, 3, 3}, {kForceful, 8, 10}};
constexpr int kMostPassesWithoutHelp = 3;
/// A round helps where the largest σ₁/σ₂ falls to this part.
constexpr double kLess = 0.95;
constexpr int kMostRoundsWithoutHelp = 3;
constexpr int kMostRounds = 12;
/// Rounds of a refinement end with so many times the vertices.
constexpr double kMostVertices = 2;

Steps<> refine_in_rounds(Workspace& work, Refinement refinement, double most_energy) {
  const double most_vertices = kMostVertices * work.mesh.vertex_count();
  Workspace best = work;
  double distortion = largest_distortion(work.mesh), least_distortion = distortion;
  int without_help = 0;
  for (int round = 0; round < kMostRounds && without_help < kMostRoundsWithoutHelp; ++round) {
    if (work.split_distorted(refinement.part * distortion) == 0 ||
        work.mesh.vertex_count() > most_vertices)
      break;
    co_await settle(work, refinement.settings);
    distortion = largest_distortion(work.mesh);
    ++without_help;
    if (distortion >= kLess * least_distortion || settled_energy(work) > most_energy) continue;
    best = work;
    least_distortion = distortion;
    without_help = 0;
    if (distortion < kCrushed) break;
  }
  work = std::move(best);
}

void take_less_distorted(Workspace& work, const Workspace& other, double most_energy) {
  if (largest_distortion(other.mesh) < largest_distortion(work.mesh) &&
      settled_energy(other) <= most_energy)
    work = other;
}

Steps<> refine_in_passes(Workspace& work, Workspace& other, Passes passes, double most_energy) {
  int without_help = 0;
  for (int pass = 0; pass < passes.most && without_help < kMostPassesWithoutHelp; ++pass) {
    const double before = largest_distortion(work.mesh);
    const int splits = work.system.effort().splits;
    for (const Refinement& refinement : passes.refinements)
      if (is_crushed(other.mesh)) co_await refine_in_rounds(other, refinement, most_energy);
    take_less_distorted(work, other, most_energy);
    if (!is_crushed(work.mesh) || work.system.effort().splits == splits) co_return;
    co_await tidy(other);
    take_less_distorted(work, other, most_energy);
    if (!is_crushed(work.mesh)) co_return;
    without_help = largest_distortion(work.mesh) < before ? 0 : without_help + 1;
  }
}

}  // namespace refining

Steps<> refine_crushed(Workspace& work) {
  using namespace refining;
  if (work.mesh.face_count() > kLargestWithCandidates || !is_crushed(work.mesh)) co_return;
  const double energy = settled_energy(work);
  Workspace other = work;
  for (const Passes& passes : kPasses)
    if (is_crushed(work.mesh))
      co_await refine_in_passes(work, other, passes, passes.dearer * energy);
  co_yield [&work](Iteration& last) { work.measure_again(last, work.held_energy()); };
}

}  // namespace foldless
