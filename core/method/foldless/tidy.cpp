// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/tidy.h"

#include <utility>

#include "core/mesh/quality.h"
#include "core/method/foldless/settle.h"

namespace foldless {
namespace tidying {

/// What flips and moves make of the mesh lets more vertices go in a second and third round.
constexpr int kMostRounds = 3;
/// By which part of E a vertex may raise it when it goes; moves take most of it back.
constexpr double kRiseOfAVertex = 1e-2;
/// By which part a round may raise E Kᵉ in the end.
constexpr double kRiseOfARound = 1e-2;
/// A mesh that was refined has more vertices than anybody asked for, and a lower E for it: while
/// more than this part of the original ones was added,
constexpr double kCrowded = 0.1;
/// the first three bounds are so many times as large, for settling mends most of what that spoils,
constexpr int kLeewayWhenCrowded = 10;
/// and what a round gives back may raise E Kᵉ by as much as it was.
constexpr double kRiseOfACrowdedRound = 1;
constexpr double kLargeExponent = 0.4;

/// By which factor the bounds are larger for this mesh.
int leeway_of(const Workspace& work) {
  const bool is_crowded =
      work.mesh.vertex_count() > (1 + kCrowded) * work.settings->first_removable;
  return is_crowded ? kLeewayWhenCrowded : 1;
}

/// True when vertices went.
bool collapse(Workspace& work, int leeway) {
  return work.collapse_edges({.energy = work.settings->energy,
                              .first_removable = work.settings->first_removable,
                              .largest_rise = leeway * kRiseOfAVertex * settled_energy(work),
                              .largest_distortion = leeway * kCrushed}) > 0;
}

Steps<> collapse_in_rounds(Workspace& work) {
  for (int round = 0; work.settings->first_removable < work.mesh.vertex_count(); ++round) {
    const int leeway = leeway_of(work);
    if (round >= leeway * kMostRounds) co_return;
    MeshPair before = work.mesh;
    const double merit_before = merit_of(work);
    if (!collapse(work, leeway)) co_return;
    co_await settle(work);
    const double rise = leeway > 1 ? kRiseOfACrowdedRound : kRiseOfARound;
    if (!(merit_of(work) <= (1 + rise) * merit_before)) {
      work.set_mesh(std::move(before));
      co_yield [&](Iteration& last) { work.measure_again(last, work.held_energy()); };
      co_return;
    }
  }
}

}  // namespace tidying

Steps<> tidy(Workspace& work) {
  using namespace tidying;
  co_await settle(work);
  co_await collapse_in_rounds(work);
  if (is_crushed(work.mesh)) co_await settle(work, {.exponent = kLargeExponent});
}

double largest_distortion(const MeshPair& mesh) {
  return quality_of(mesh.triangles(), mesh.rest(), mesh.deformed()).max_conformal_distortion;
}

bool is_crushed(const MeshPair& mesh) { return largest_distortion(mesh) >= kCrushed; }

}  // namespace foldless
