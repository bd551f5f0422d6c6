// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/refine_crushed.h"

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
constexpr Refinement kRefinements[] = {{0.7, {.exponent = 0.4}},
                                       {0.7, {.exponent = 0.4, .power = 16}},
                                       {0.2, {.exponent = 0.4, .power = 16}},
                                       {0.7, {.exponent = 1.5, .power = 16}},
                                       {0.2, {.exponent = 1.5, .power = 16}}};
/// A round helps where the largest σ₁/σ₂ falls to this part.
constexpr double kLess = 0.95;
/// and E is at most so many times that of the mesh before all rounds.
constexpr double kDearer = 3;
constexpr int kMostRoundsWithoutHelp = 3;
constexpr int kMostRounds = 12;
/// Rounds end with so many times the vertices.
constexpr double kMostVertices = 2;

/// Where rounds end.
struct Limits {
  int vertices;
  double energy;
};

Steps<> refine_in_rounds(Workspace& work, Refinement refinement, Limits limits) {
  Workspace best = work;
  double distortion = largest_distortion(work.mesh), least_distortion = distortion;
  int without_help = 0;
  for (int round = 0; round < kMostRounds && without_help < kMostRoundsWithoutHelp; ++round) {
    if (work.split_distorted(refinement.part * distortion) == 0 ||
        work.mesh.vertex_count() > limits.vertices)
      break;
    co_await settle(work, refinement.settings);
    distortion = largest_distortion(work.mesh);
    ++without_help;
    if (distortion >= kLess * least_distortion || settled_energy(work) > limits.energy) continue;
    best = work;
    least_distortion = distortion;
    without_help = 0;
    if (distortion < kCrushed) break;
  }
  work = std::move(best);
}

}  // namespace refining

Steps<> refine_crushed(Workspace& work) {
  using namespace refining;
  if (work.mesh.face_count() > kLargestWithCandidates || !is_crushed(work.mesh)) co_return;
  const Limits limits{static_cast<int>(kMostVertices * work.mesh.vertex_count()),
                      kDearer * settled_energy(work)};
  for (const Refinement& refinement : kRefinements)
    if (is_crushed(work.mesh)) co_await refine_in_rounds(work, refinement, limits);
  co_yield [&work](Iteration& last) { work.measure_again(last, work.held_energy()); };
}

}  // namespace foldless
