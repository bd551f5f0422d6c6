// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace foldless::test {

/// While it lives, one allocation fails of those that other threads make by `new`: the n-th, from
/// 1. One at a time; a program that is linked with it.
class FailingAllocation {
 public:
  explicit FailingAllocation(long n);
  ~FailingAllocation();
  FailingAllocation(const FailingAllocation&) = delete;
  FailingAllocation& operator=(const FailingAllocation&) = delete;

  /// False while there were fewer.
  bool has_happened() const;
};

}  // namespace foldless::test
