// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace foldless {

/// Makes values as `new Value` does: numbers are not set.
template <class Value>
struct UnfilledAllocator : std::allocator<Value> {
  template <class Made, class... Arguments>
  void construct(Made* place, Arguments&&... arguments) {
    if constexpr (sizeof...(arguments) == 0)
      ::new (static_cast<void*>(place)) Made;
    else
      std::construct_at(place, std::forward<Arguments>(arguments)...);
  }
};

/// A vector of numbers whose resize() does not touch them, so that the threads that fill it are the
/// first that do.
template <class Value>
using UnfilledVector = std::vector<Value, UnfilledAllocator<Value>>;

}  // namespace foldless
