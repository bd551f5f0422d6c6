// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>

#include "core/large_pages.h"
#include "core/threads/used_memory.h"

namespace foldless {

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
    values_.reset(static_cast<Value*>(take_memory(room * sizeof(Value))));
    size_ = room;
    ask_for_large_pages(values_.get(), room * sizeof(Value));
  }

 private:
  struct GiveBack {
    void operator()(Value* values) const noexcept { give_back_memory(values); }
  };

  std::unique_ptr<Value[], GiveBack> values_;
  std::size_t size_ = 0;
};

}  // namespace foldless
