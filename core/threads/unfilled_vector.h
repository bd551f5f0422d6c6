// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <utility>
#include <vector>

#include "core/threads/used_memory.h"

namespace foldless {

/// Makes values as `new Value` does: numbers are not set.
template <class Value>
struct UnfilledAllocator {
  using value_type = Value;

  Value* allocate(std::size_t count) {
    if (count > static_cast<std::size_t>(-1) / 2 / sizeof(Value)) throw std::bad_array_new_length();
    return static_cast<Value*>(take_memory(count * sizeof(Value)));
  }
  void deallocate(Value* values, std::size_t) noexcept { give_back_memory(values); }
  bool operator==(const UnfilledAllocator&) const = default;

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
