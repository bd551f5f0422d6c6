// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remesh/edge_heap.h"

#include <gtest/gtest.h>

namespace foldless {
namespace {

TEST(EdgeHeap, GivesEdgesInDescendingOrderOfTheirGain) {
  EdgeHeap heap(5);
  heap.push(3, 0.5);
  heap.push(1, 2);
  heap.push(4, 1);
  EXPECT_EQ(heap.pop(), 1);
  EXPECT_EQ(heap.pop(), 4);
  EXPECT_EQ(heap.pop(), 3);
  EXPECT_EQ(heap.pop(), std::nullopt);
}

TEST(EdgeHeap, ErasedEdgesDoNotComeOut) {
  EdgeHeap heap(5);
  heap.push(3, 0.5);
  heap.push(1, 2);
  heap.erase(1);
  heap.erase(0);
  EXPECT_EQ(heap.pop(), 3);
  EXPECT_EQ(heap.pop(), std::nullopt);
}

TEST(EdgeHeap, EqualGainsComeInTheOrderOfTheirIndices) {
  EdgeHeap heap(9);
  for (const int e : {7, 2, 5}) heap.push(e, 1);
  EXPECT_EQ(heap.pop(), 2);
  EXPECT_EQ(heap.pop(), 5);
  EXPECT_EQ(heap.pop(), 7);
}

}  // namespace
}  // namespace foldless
