// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>

namespace foldless {

/// Asks the system to make this memory of large pages, where it does so when asked: of a factor
/// that fills for the first time every small page is a fault. To be called before anything is
/// written there; it changes no more than time.
void ask_for_large_pages(void* memory, std::size_t bytes);

/// Values that are not initialised.
template <class Value>
class Buffer {
 public:
  Value* data() { return values_.get(); }
  const Value* data() const { return values_.get(); }
  /// Makes room; what was in it is lost where it was too small. There is some to spare, for the
  /// next factor may be a little larger, and memory that was not used before is dear. Throws
  /// std::bad_alloc.
  void reserve(std::size_t size) {
    if (size <= size_) return;
    values_.reset();
    size_ = 0;
    const std::size_t room = size + size / 4;
    values_ = std::make_unique_for_overwrite<Value[]>(room);
    size_ = room;
    ask_for_large_pages(values_.get(), room * sizeof(Value));
  }

 private:
  std::unique_ptr<Value[]> values_;
  std::size_t size_ = 0;
};

}  // namespace foldless
