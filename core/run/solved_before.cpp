// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/solved_before.h"

#include <algorithm>
#include <utility>

namespace foldless {
namespace {

/// Two rounds of a loop, before and after an edit.
constexpr std::size_t kMostOfAMoment = 4;

bool is_equal(const Snapshot* a, const Snapshot* b) {
  if (a == b) return true;
  if (!a || !b || a->deformed.cols() != b->deformed.cols() ||
      a->triangles->cols() != b->triangles->cols())
    return false;
  return a->deformed == b->deformed && (a->rest == b->rest || *a->rest == *b->rest) &&
         (a->triangles == b->triangles || *a->triangles == *b->triangles);
}

}  // namespace

void SolvedBefore::add(const std::shared_ptr<const Snapshot>& before, std::vector<Handle> handles,
                       const SolvedFrame& frame) {
  if (find(frame.frame, before.get(), handles)) return;
  std::deque<Entry>& of_moment = entries_[frame.frame];
  of_moment.push_back({before, std::move(handles), frame});
  if (of_moment.size() > kMostOfAMoment) of_moment.pop_front();
}

const SolvedFrame* SolvedBefore::find(double moment, const Snapshot* before,
                                      const std::vector<Handle>& handles) const {
  const auto of_moment = entries_.find(moment);
  if (of_moment == entries_.end()) return nullptr;
  const auto found = std::ranges::find_if(of_moment->second, [&](const Entry& entry) {
    return entry.handles == handles && is_equal(entry.before.get(), before);
  });
  return found == of_moment->second.end() ? nullptr : &found->frame;
}

}  // namespace foldless
