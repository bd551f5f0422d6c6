// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <mutex>
#include <utility>

namespace foldless {

/// A slot for the latest value of one thread, read by others: readers may skip values but never
/// see half of one, and nobody waits for longer than it takes to copy a pointer.
template <typename T>
class Channel {
 public:
  void publish(std::shared_ptr<const T> value) {
    // The old value is let go after the lock: its destructor may take long.
    std::lock_guard lock(mutex_);
    latest_.swap(value);
  }

  /// The value published last, or null before the first.
  std::shared_ptr<const T> latest() const {
    std::lock_guard lock(mutex_);
    return latest_;
  }

 private:
  mutable std::mutex mutex_;
  std::shared_ptr<const T> latest_;
};

}  // namespace foldless
