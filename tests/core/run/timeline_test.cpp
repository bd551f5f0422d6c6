// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/timeline.h"

#include <gtest/gtest.h>

#include <unordered_set>

namespace foldless {
namespace {

/// Snapshots of one mesh, or each of its own connectivity.
std::shared_ptr<const Snapshot> snapshot_of(int vertices, const Snapshot* shared) {
  Snapshot snapshot;
  if (shared) snapshot = *shared;
  if (!shared) {
    snapshot.triangles = std::make_shared<const Triangles>(Triangles::Zero(3, 2 * vertices));
    snapshot.rest = std::make_shared<const Points>(Points::Zero(2, vertices));
    snapshot.flipped_edges = std::make_shared<const std::vector<Edge>>();
  }
  snapshot.deformed = Points::Zero(2, vertices);
  return std::make_shared<const Snapshot>(snapshot);
}

/// The memory of all arrays that the timeline holds, shared ones once.
std::size_t measured_bytes(const Timeline& timeline) {
  std::unordered_set<const void*> seen;
  std::size_t bytes = 0;
  for (const TimelineEntry& entry : timeline.entries()) {
    if (!entry.snapshot) continue;
    const Snapshot& s = *entry.snapshot;
    bytes += static_cast<std::size_t>(s.deformed.size()) * sizeof(double);
    if (seen.insert(s.rest.get()).second)
      bytes += static_cast<std::size_t>(s.rest->size()) * sizeof(double);
    if (seen.insert(s.triangles.get()).second)
      bytes += static_cast<std::size_t>(s.triangles->size()) * sizeof(int);
  }
  return bytes;
}

int kept(const Timeline& timeline) {
  int count = 0;
  for (const TimelineEntry& entry : timeline.entries()) count += entry.snapshot ? 1 : 0;
  return count;
}

TEST(Timeline, KeepsEveryRecordAndStaysBelowItsCap) {
  for (const bool is_shared : {true, false}) {
    constexpr std::size_t kCap = 200'000;
    Timeline timeline(kCap);
    const auto first = snapshot_of(100, nullptr);
    for (int i = 0; i < 3000; ++i) {
      Iteration record;
      record.inner = i;
      timeline.append(record, snapshot_of(100, is_shared ? first.get() : nullptr));
      ASSERT_LE(timeline.bytes(), kCap);
      ASSERT_LE(measured_bytes(timeline), timeline.bytes());
      ASSERT_TRUE(timeline.entries().front().snapshot);
      ASSERT_TRUE(timeline.entries().back().snapshot);
    }
    ASSERT_EQ(timeline.entries().size(), 3000U);
    for (int i = 0; i < 3000; ++i)
      ASSERT_EQ(timeline.entries()[static_cast<std::size_t>(i)].record.inner, i);
    EXPECT_GT(timeline.bytes(), kCap / 8) << "thinned more than needed";
  }
}

TEST(Timeline, ThinsEvenly) {
  Timeline timeline(100'000);
  const auto first = snapshot_of(100, nullptr);
  for (int i = 0; i < 1000; ++i) timeline.append({}, snapshot_of(100, first.get()));
  std::size_t gap = 0;
  std::size_t widest = 0;
  for (const TimelineEntry& entry : timeline.entries()) {
    gap = entry.snapshot ? 0 : gap + 1;
    widest = std::max(widest, gap);
  }
  EXPECT_LT(widest, 8 * 1000 / static_cast<std::size_t>(kept(timeline)));
}

TEST(Timeline, KeepsAllSnapshotsBelowTheCap) {
  Timeline timeline(std::size_t{1} << 20);
  const auto first = snapshot_of(100, nullptr);
  for (int i = 0; i < 100; ++i) timeline.append({}, snapshot_of(100, first.get()));
  EXPECT_EQ(kept(timeline), 100);
}

TEST(Timeline, KeepsTheNewestSnapshotThoughItAloneIsLargerThanTheCap) {
  Timeline timeline(1000);
  for (int i = 0; i < 10; ++i) timeline.append({}, snapshot_of(1000, nullptr));
  EXPECT_TRUE(timeline.entries().back().snapshot);
  EXPECT_EQ(timeline.entries().size(), 10U);
}

TEST(Timeline, CountsItsStarts) {
  Timeline timeline(1000);
  const auto epoch = timeline.epoch();
  timeline.append({}, nullptr);
  EXPECT_EQ(timeline.epoch(), epoch);
  timeline.clear();
  EXPECT_EQ(timeline.epoch(), epoch + 1);
  EXPECT_TRUE(timeline.entries().empty());
  EXPECT_TRUE(timeline.from(5).empty());
}

}  // namespace
}  // namespace foldless
