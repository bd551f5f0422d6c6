// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/rivals.h"

#include <utility>

#include "core/method/foldless/candidates.h"
#include "core/method/foldless/hop.h"
#include "core/method/foldless/tidy.h"

namespace foldless {

Steps<> try_rivals(Workspace& work, OtherWays& ways) {
  const double most_distortion = most_distortion_beside(work.mesh);
  co_await hop(work);
  const Effort& effort = work.system.effort();
  const int last = effort.factorizations + kMostOfRivals;
  bool has_gone = false;
  while (!has_gone && !ways.have_ended() && effort.factorizations < last) {
    Workspace other = work;
    const bool is_cut = ways.next().kind == Way::Kind::cut;
    const auto progress =
        co_await within(last - effort.factorizations, effort, ways.try_next(other));
    if (progress != Progress::arrived) continue;
    co_await tidy(other);
    co_await hop(other);
    has_gone = !is_cut && !is_crushed(other.mesh);
    if (largest_distortion(other.mesh) <= most_distortion && has_less_energy(other, work))
      work = std::move(other);
  }
  co_yield [&work](Iteration& last_one) { work.measure_again(last_one, work.held_energy()); };
}

}  // namespace foldless
