// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/refine_distorted.h"

#include <algorithm>
#include <utility>

#include "core/method/foldless/settle.h"
#include "core/method/foldless/tidy.h"

namespace foldless {
namespace refining_distorted {

/// Triangles; larger meshes mostly have a coarse one, which is refined.
constexpr int kLargest = 4000;
/// Where no σ₁/σ₂ is above this nothing is refined. A lower bound betters more shapes, for more
/// vertices.
constexpr double kDistorted = 50;
static_assert(kDistorted > kHardlyDistorted);
/// Of triangles with this part of the largest σ₁/σ₂ and more edges are split,
constexpr double kPart = 0.1;
/// but of none below.
constexpr double kLeast = 30;
/// New vertices are worth it where E Kᵉ falls to this part.
constexpr double kWorthIt = 0.95;
/// A round that leaves more than this part is the last: the next one is hardly worth it.
constexpr double kGoesOn = 0.9;
constexpr int kMostRounds = 8;
/// Rounds end with so many times the vertices.
constexpr double kMostVertices = 1.5;

}  // namespace refining_distorted

Steps<> refine_distorted(Workspace& work) {
  using namespace refining_distorted;
  if (work.mesh.face_count() > kLargest || is_crushed(work.mesh) ||
      largest_distortion(work.mesh) < kDistorted)
    co_return;
  const auto most_vertices = static_cast<int>(kMostVertices * work.mesh.vertex_count());
  Workspace other = work;
  double merit = merit_of(work);
  for (int round = 0; round < kMostRounds; ++round) {
    const double least = std::max(kPart * largest_distortion(other.mesh), kLeast);
    const int room = most_vertices - other.mesh.vertex_count();
    if (other.split_distorted(least, room) == 0) break;
    co_await settle(other);
    const double before = std::exchange(merit, merit_of(other));
    if (is_crushed(other.mesh) || merit > kWorthIt * before) break;
    work = other;
    if (merit > kGoesOn * before) break;
  }
  co_yield [&work](Iteration& last) { work.measure_again(last, work.held_energy()); };
}

}  // namespace foldless
