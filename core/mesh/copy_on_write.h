// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <utility>

namespace foldless {

/// A value whose copies share it until one of them changes it. With a count of its own, for whether
/// others have a std::shared_ptr cannot be asked in step with what they did before they gave it up.
/// Copies may be used on different threads at the same time, as if they did not share anything.
template <class Value>
class CopyOnWrite {
 public:
  CopyOnWrite() = default;
  explicit CopyOnWrite(Value value) : shared_(new Shared{std::move(value)}) {}
  CopyOnWrite(const CopyOnWrite& other) : shared_(other.shared_) {
    if (shared_) shared_->users.fetch_add(1, std::memory_order_relaxed);
  }
  CopyOnWrite(CopyOnWrite&& other) noexcept : shared_(std::exchange(other.shared_, nullptr)) {}
  CopyOnWrite& operator=(CopyOnWrite other) noexcept {
    std::swap(shared_, other.shared_);
    return *this;
  }
  ~CopyOnWrite() {
    // What others read of it comes before it goes, or before the last one changes it.
    if (shared_ && shared_->users.fetch_sub(1, std::memory_order_acq_rel) == 1) delete shared_;
  }

  const Value& operator*() const { return shared_ ? shared_->value : none(); }
  const Value* operator->() const { return &**this; }
  /// The value to be changed, which no other copy has from now on. Throws std::bad_alloc.
  Value& own() {
    if (!shared_ || shared_->users.load(std::memory_order_acquire) > 1)
      *this = CopyOnWrite(Value(**this));
    return shared_->value;
  }
  /// Puts another in its place: what refers to it goes on to, unless another copy has it.
  void set(Value value) {
    if (!shared_ || shared_->users.load(std::memory_order_acquire) > 1)
      *this = CopyOnWrite(std::move(value));
    else
      shared_->value = std::move(value);
  }

 private:
  struct Shared {
    Value value;
    std::atomic<int> users = 1;
  };
  /// Apart, so that operator*() is short enough to be inlined.
  static const Value& none() {
    static const Value value{};
    return value;
  }

  Shared* shared_ = nullptr;
};

}  // namespace foldless
