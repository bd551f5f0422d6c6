// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/hop.h"

#include <array>
#include <utility>

#include "core/method/foldless/candidates.h"
#include "core/method/foldless/settle.h"
#include "core/method/foldless/tidy.h"

namespace foldless {
namespace hopping {

/// ε of each hop: one that goes far, one that stays near what that found, and one that goes far
/// from there.
constexpr std::array kExponents = {20.0, 1.5, 20.0};
/// Than a crushed mesh one is better whose largest σ₁/σ₂ is below this part of the other's,
constexpr double kLessCrushed = 0.8;
/// if it has at most so many times the E.
constexpr double kDearer = 1.5;
/// A hop that lowers E by less than this part of it is the last: the next one seldom finds more.
constexpr double kLeastGain = 0.01;

bool is_better(const Workspace& work, const Workspace& other, double most_distortion) {
  const double distortion = largest_distortion(work.mesh);
  if (is_crushed(other.mesh) && distortion < kLessCrushed * largest_distortion(other.mesh))
    return settled_energy(work) <= kDearer * settled_energy(other);
  return distortion <= most_distortion && has_less_energy(work, other);
}

}  // namespace hopping

Steps<> hop(Workspace& work) {
  using namespace hopping;
  if (work.mesh.face_count() > kLargestWithCandidates) co_return;
  if (largest_distortion(work.mesh) <= kHardlyDistorted) co_return;
  const double most_distortion = most_distortion_beside(work.mesh);
  for (const double exponent : kExponents) {
    Workspace other = work;
    co_await settle(other, {.exponent = exponent});
    co_await tidy(other);
    if (!is_better(other, work, most_distortion)) break;
    const bool is_last =
        settled_energy(other) > (1 - kLeastGain) * settled_energy(work) && !is_crushed(other.mesh);
    work = std::move(other);
    if (is_last) break;
  }
  co_yield [&work](Iteration& last) { work.measure_again(last, work.held_energy()); };
}

}  // namespace foldless
