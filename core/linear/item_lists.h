// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

#include "core/large_pages.h"
#include "core/threads/unfilled_vector.h"

namespace foldless {

/// Lists, one after the other.
template <class Item>
struct ItemLists {
  std::vector<std::size_t> start;  ///< of every list, and where the last ends
  UnfilledVector<Item> items;

  int count() const { return static_cast<int>(start.size()) - 1; }
  std::span<const Item> of(int list) const {
    const auto k = static_cast<std::size_t>(list);
    return {items.data() + start[k], start[k + 1] - start[k]};
  }

  /// Makes room where start[k + 1] is the size of the k-th list, and start[0] is 0.
  void make_room() {
    std::partial_sum(start.begin(), start.end(), start.begin());
    reserve_large_pages(items, start.back());
    items.resize(start.back());
  }
};

}  // namespace foldless
