// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/channel.h"

#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <thread>

#include "tests/support/patience.h"

namespace foldless {
namespace {

struct Pair {
  int first = 0;
  int second = 0;
};

TEST(Channel, IsEmptyBeforeTheFirstValue) {
  const Channel<Pair> channel;
  EXPECT_EQ(channel.latest(), nullptr);
}

TEST(Channel, ReadersSeeWholeValuesInOrder) {
  Channel<Pair> channel;
  constexpr int kCount = 20000;
  const std::jthread writer([&] {
    for (int i = 1; i <= kCount; ++i) channel.publish(std::make_shared<const Pair>(Pair{i, -i}));
  });
  int last = 0;
  while (last < kCount) {
    const auto value = channel.latest();
    if (!value) continue;
    ASSERT_EQ(value->first, -value->second);
    ASSERT_GE(value->first, last);
    last = value->first;
  }
}

TEST(Channel, EveryReaderGetsTheNewestValue) {
  Channel<Pair> channel;
  for (int k = 1; k <= 3; ++k) {
    const auto value = std::make_shared<const Pair>(Pair{k, -k});
    channel.publish(value);
    EXPECT_EQ(channel.latest(), value);
    EXPECT_EQ(channel.latest(), value);
  }
}

TEST(Channel, NobodyWaitsForTheEndOfAnOldValue) {
  Channel<Pair> channel;
  bool was_read_meanwhile = false;
  const auto end = [&](const Pair* pair) {
    std::promise<void> read;
    std::jthread reader([&] {
      channel.latest();
      read.set_value();
    });
    was_read_meanwhile = read.get_future().wait_for(test::kPatience) == std::future_status::ready;
    // A reader that is locked out could not be joined before the value has ended.
    if (!was_read_meanwhile) std::abort();
    delete pair;
  };
  channel.publish(std::shared_ptr<const Pair>(new Pair, end));
  channel.publish(std::make_shared<const Pair>());
  EXPECT_TRUE(was_read_meanwhile);
}

}  // namespace
}  // namespace foldless
