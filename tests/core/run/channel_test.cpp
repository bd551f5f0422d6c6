// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/channel.h"

#include <gtest/gtest.h>

#include <thread>

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

}  // namespace
}  // namespace foldless
