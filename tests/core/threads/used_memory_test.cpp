// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/threads/used_memory.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <thread>
#include <vector>

#include "core/threads/unfilled_vector.h"

namespace foldless {
namespace {

constexpr std::size_t kSome = 100'000;

/// A new thread has given nothing back yet.
template <class Task>
void on_a_new_thread(const Task& task) {
  std::thread(task).join();
}

TEST(UsedMemory, ServesAgainForAsMuchOrSomewhatLess) {
  on_a_new_thread([] {
    for (const std::size_t next : {kSome, kSome / 3}) {
      void* first = take_memory(kSome);
      give_back_memory(first);
      void* again = take_memory(next);
      EXPECT_EQ(again, first);
      give_back_memory(again);
    }
  });
}

TEST(UsedMemory, DoesNotServeForMoreOrForMuchLess) {
  on_a_new_thread([] {
    for (const std::size_t next : {kSome + 1, kSome / 5}) {
      void* first = take_memory(kSome);
      give_back_memory(first);
      void* other = take_memory(next);
      EXPECT_NE(other, first);
      std::memset(other, 1, next);
      void* again = take_memory(kSome);
      EXPECT_EQ(again, first) << "it was still there";
      give_back_memory(other);
      give_back_memory(again);
    }
  });
}

TEST(UsedMemory, TheSmallestThatDoesServes) {
  on_a_new_thread([] {
    void* larger = take_memory(kSome + 16);
    void* smaller = take_memory(kSome);
    give_back_memory(smaller);
    give_back_memory(larger);
    void* again = take_memory(kSome - 16);
    EXPECT_EQ(again, smaller);
    give_back_memory(again);
  });
}

TEST(UsedMemory, IsNobodyElsesWhileItIsTaken) {
  std::vector<unsigned char*> taken;
  for (int round = 0; round < 3; ++round) {
    for (int i = 0; i < 100; ++i) {
      taken.push_back(static_cast<unsigned char*>(take_memory(kSome)));
      EXPECT_EQ(reinterpret_cast<std::uintptr_t>(taken.back()) % alignof(std::max_align_t), 0U);
      std::memset(taken.back(), i, kSome);
    }
    for (int i = 0; i < 100; ++i) {
      const unsigned char* block = taken[static_cast<std::size_t>(i)];
      EXPECT_EQ(block[0], i);
      EXPECT_EQ(block[kSome - 1], i);
    }
    for (unsigned char* block : taken) give_back_memory(block);  // more than are kept
    taken.clear();
  }
}

TEST(UsedMemory, IsKeptByTheThreadThatGivesItBack) {
  void* first = take_memory(kSome);
  on_a_new_thread([&] {
    give_back_memory(first);
    void* again = take_memory(kSome);
    EXPECT_EQ(again, first);
    give_back_memory(again);
  });
}

TEST(UsedMemory, AVectorThatIsNotFilledLivesThere) {
  on_a_new_thread([] {
    const int* values = nullptr;
    {
      UnfilledVector<int> vector(kSome);
      values = vector.data();
    }
    const UnfilledVector<int> next(kSome);
    EXPECT_EQ(next.data(), values);
  });
}

TEST(UsedMemoryDeath, AnAddressSanitizerKnowsThatItWasGivenBack) {
#ifdef __has_feature
#if __has_feature(address_sanitizer)
  auto* values = static_cast<volatile int*>(take_memory(kSome));
  give_back_memory(const_cast<int*>(values));
  EXPECT_DEATH(values[7] = 1, "use-after-poison");
  return;
#endif
#endif
  GTEST_SKIP() << "there is none";
}

}  // namespace
}  // namespace foldless
