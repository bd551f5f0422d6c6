// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/timeline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
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

TEST(Timeline, CountsEveryArrayOfASnapshotAndSharedOnesOnce) {
  Timeline timeline(std::size_t{1} << 20);
  Snapshot first = *snapshot_of(100, nullptr);
  first.flipped_edges = std::make_shared<const std::vector<Edge>>(7);
  first.handles.resize(5);
  for (int k = 0; k < 3; ++k) timeline.append({}, snapshot_of(100, &first));
  const std::size_t own = 2 * 100 * sizeof(double) + 5 * sizeof(Handle) + sizeof(Snapshot);
  const std::size_t shared = 2 * 100 * sizeof(double) + 3 * 200 * sizeof(int) + 7 * sizeof(Edge);
  EXPECT_EQ(timeline.bytes(), 3 * own + shared);
}

TEST(Timeline, LetsEverySecondFourthEighthSnapshotStay) {
  Timeline timeline(50'000);
  const auto first = snapshot_of(100, nullptr);
  std::size_t widest = 1;
  for (int i = 0; i < 500; ++i) {
    timeline.append({}, snapshot_of(100, first.get()));
    std::size_t gap = 1;
    while (gap < timeline.entries().size() && !timeline.entries()[gap].snapshot) ++gap;
    ASSERT_TRUE(std::has_single_bit(gap)) << gap << " after " << i;
    ASSERT_GE(gap, widest);
    widest = gap;
  }
  EXPECT_GE(widest, 16U);
}

TEST(Timeline, MakesRoomForAWhile) {
  constexpr std::size_t kCap = 50'000;
  Timeline timeline(kCap);
  const auto first = snapshot_of(100, nullptr);
  int thinned = 0;
  for (int i = 0; i < 500; ++i) {
    const std::size_t before = timeline.bytes();
    timeline.append({}, snapshot_of(100, first.get()));
    if (timeline.bytes() > before) continue;
    ++thinned;
    EXPECT_LE(timeline.bytes(), kCap - kCap / 4) << i;
  }
  EXPECT_GT(thinned, 0);
}

TEST(Timeline, IsAsNewAfterAStart) {
  const auto first = snapshot_of(100, nullptr);
  const auto fill = [&](Timeline& timeline, int count) {
    for (int i = 0; i < count; ++i) timeline.append({}, snapshot_of(100, first.get()));
  };
  Timeline fresh(50'000);
  fill(fresh, 10);
  Timeline cleared(50'000);
  fill(cleared, 300);
  cleared.clear();
  EXPECT_EQ(cleared.bytes(), 0U);
  fill(cleared, 10);
  EXPECT_EQ(cleared.bytes(), fresh.bytes());
  fill(fresh, 40);
  fill(cleared, 40);
  EXPECT_EQ(cleared.bytes(), fresh.bytes());
  EXPECT_EQ(kept(cleared), kept(fresh));
}

TEST(Timeline, GivesTheEntriesFromAnIndexOn) {
  Timeline timeline(50'000);
  for (int i = 0; i < 4; ++i) {
    Iteration record;
    record.inner = i;
    timeline.append(record, nullptr);
  }
  for (int first = 0; first <= 5; ++first) {
    const auto rest = timeline.from(static_cast<std::size_t>(first));
    ASSERT_EQ(static_cast<int>(rest.size()), std::max(4 - first, 0));
    if (!rest.empty()) {
      EXPECT_EQ(rest.front().record.inner, first);
    }
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
