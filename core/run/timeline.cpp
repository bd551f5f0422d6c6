// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/timeline.h"

#include <utility>

#include "core/run/adopted_pose.h"

namespace foldless {

void Timeline::append(const Iteration& record, std::shared_ptr<const Snapshot> snapshot) {
  if (snapshot) {
    bytes_ += added_bytes(*snapshot, last_kept_.get());
    last_kept_ = snapshot;
  }
  entries_.push_back({record, std::move(snapshot)});
  if (bytes_ <= cap_) return;
  thin();
  // Room for a while, so that a long run is not thinned at every iteration.
  while (bytes_ > cap_ - cap_ / 4 && stride_ < entries_.size()) {
    stride_ *= 2;
    thin();
  }
}

// The first iteration stays as long as any other does, and the newest always.
void Timeline::thin() {
  bytes_ = 0;
  last_kept_ = nullptr;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    std::shared_ptr<const Snapshot>& snapshot = entries_[i].snapshot;
    if (i % stride_ != 0 && i + 1 < entries_.size()) snapshot = nullptr;
    if (!snapshot) continue;
    bytes_ += added_bytes(*snapshot, last_kept_.get());
    last_kept_ = snapshot;
  }
}

void Timeline::clear() {
  entries_.clear();
  last_kept_ = nullptr;
  bytes_ = 0;
  stride_ = 1;
  ++epoch_;
}

std::vector<TimelineEntry> Timeline::from(std::size_t first) const {
  if (first >= entries_.size()) return {};
  return {entries_.begin() + static_cast<std::ptrdiff_t>(first), entries_.end()};
}

}  // namespace foldless
