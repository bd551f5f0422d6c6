// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/copy_on_write.h"

#include <gtest/gtest.h>

#include <thread>
#include <utility>
#include <vector>

namespace foldless {
namespace {

using Numbers = CopyOnWrite<std::vector<int>>;

TEST(CopyOnWrite, CopiesShareUntilOneChanges) {
  Numbers first(std::vector{1, 2});
  const Numbers second = first;
  EXPECT_EQ(&*first, &*second);
  first.own().push_back(3);
  EXPECT_EQ(first->size(), 3U);
  EXPECT_EQ(second->size(), 2U);
}

TEST(CopyOnWrite, WhatIsNotSharedIsNotCopied) {
  Numbers numbers(std::vector{1, 2});
  const std::vector<int>* const before = &*numbers;
  { const Numbers copy = numbers; }
  EXPECT_EQ(&numbers.own(), before);
  Numbers moved = std::move(numbers);
  EXPECT_EQ(&moved.own(), before);
}

TEST(CopyOnWrite, AnotherValueIsPutInItsPlaceWhereNobodySharesIt) {
  Numbers first(std::vector{1, 2});
  const std::vector<int>& own = *first;
  first.set({3});
  EXPECT_EQ(own, std::vector{3});
  const Numbers second = first;
  first.set({4, 5});
  EXPECT_EQ(*first, (std::vector{4, 5}));
  EXPECT_EQ(*second, std::vector{3});
  Numbers none;
  none.set({6});
  EXPECT_EQ(*none, std::vector{6});
}

TEST(CopyOnWrite, WithoutAValueItIsThatOfNothing) {
  Numbers numbers;
  EXPECT_TRUE(numbers->empty());
  numbers.own().push_back(1);
  EXPECT_EQ(numbers->size(), 1U);
  EXPECT_TRUE(Numbers()->empty());
  numbers = Numbers();
  EXPECT_TRUE(numbers->empty());
}

// What one thread has read of it another changes: the thread sanitizer looks on.
TEST(CopyOnWrite, OnThreadsItIsAsIfTheyHadTheirOwn) {
  for (int round = 0; round < 100; ++round) {
    Numbers mine(std::vector<int>(64, 1));
    int sum = 0;
    std::thread other([copy = mine, &sum]() mutable {
      for (const int number : *copy) sum += number;
      copy = Numbers();
    });
    mine.own()[0] = 2;
    other.join();
    EXPECT_EQ(sum, 64);
    EXPECT_EQ(mine->front(), 2);
  }
}

}  // namespace
}  // namespace foldless
