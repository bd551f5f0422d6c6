// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace foldless {

/// Asks the system to make this memory of large pages, where it does so when asked: of what fills
/// for the first time every small page is a fault. To be called before anything is written there;
/// it changes no more than time.
void ask_for_large_pages(void* memory, std::size_t bytes);

/// The same of what a vector will hold, which is empty yet.
template <class Value, class Allocator>
void reserve_large_pages(std::vector<Value, Allocator>& values, std::size_t size) {
  values.reserve(size);
  ask_for_large_pages(values.data(), size * sizeof(Value));
}

}  // namespace foldless
