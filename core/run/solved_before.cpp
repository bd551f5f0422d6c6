// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/solved_before.h"

#include <algorithm>
#include <utility>

#include "core/run/adopted_pose.h"

namespace foldless {
namespace {

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
  const std::size_t bytes = added_bytes(*frame.snapshot, before.get());
  entries_[frame.frame].push_back({before, std::move(handles), frame, bytes});
  added_.push_back(frame.frame);
  bytes_ += bytes;
  while (bytes_ > most_bytes_) remove_first();
}

void SolvedBefore::remove_first() {
  const auto of_moment = entries_.find(added_.front());
  added_.pop_front();
  bytes_ -= of_moment->second.front().bytes;
  of_moment->second.pop_front();
  if (of_moment->second.empty()) entries_.erase(of_moment);
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
