// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/iteration.h"
#include "core/snapshot.h"

namespace foldless {

/// One iteration on the timeline. The record is always there; the snapshot is null where it was
/// let go because the memory cap was reached, or where none was published.
struct TimelineEntry {
  Iteration record;
  std::shared_ptr<const Snapshot> snapshot;
};

/// What a reader of a timeline gets.
struct TimelinePart {
  std::uint64_t epoch = 0;  ///< counts the starts: another one makes a reader's copy out of date
  std::vector<TimelineEntry> entries;
};

/// Every iteration in order, with as many snapshots as a memory cap allows: when it is reached,
/// those between every second, fourth, eighth … iteration are let go. Not thread-safe.
class Timeline {
 public:
  /// The cap counts the arrays of the snapshots, shared ones once. [bytes]
  explicit Timeline(std::size_t cap) : cap_(cap) {}

  void append(const Iteration& record, std::shared_ptr<const Snapshot> snapshot);
  /// Starts anew.
  void clear();

  const std::vector<TimelineEntry>& entries() const { return entries_; }
  /// The entries from index `first` on.
  std::vector<TimelineEntry> from(std::size_t first) const;
  /// Counts the starts.
  std::uint64_t epoch() const { return epoch_; }
  /// Memory that the snapshots take. [bytes]
  std::size_t bytes() const { return bytes_; }

 private:
  void thin();

  std::size_t cap_;
  std::vector<TimelineEntry> entries_;
  std::shared_ptr<const Snapshot> last_kept_;  ///< whose shared arrays are counted already
  std::size_t bytes_ = 0;
  std::size_t stride_ = 1;  ///< snapshots of indices that it does not divide go first
  std::uint64_t epoch_ = 0;
};

}  // namespace foldless
