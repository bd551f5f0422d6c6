// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <stop_token>

#include "core/linear/symbolic_factor.h"

namespace foldless {

/// Values that are not initialised.
template <class Value>
class Buffer {
 public:
  Value* data() { return values_.get(); }
  const Value* data() const { return values_.get(); }
  /// Makes room; what was in it is lost where it was too small. There is some to spare, for the
  /// next factor may be a little larger, and memory that was not used before is dear: every page of
  /// it is a fault. Throws std::bad_alloc.
  void reserve(std::size_t size) {
    if (size <= size_) return;
    values_.reset();
    size_ = 0;
    const std::size_t room = size + size / 4;
    values_ = std::make_unique_for_overwrite<Value[]>(room);
    size_ = room;
  }

 private:
  std::unique_ptr<Value[]> values_;
  std::size_t size_ = 0;
};

/// The Cholesky factor of matrix + shift·I by the multifrontal method [Liu92] into `values`, which
/// have room for factor.values, with the inverse of its diagonal on the diagonal. Returns the
/// number of columns, or one, in the order of elimination, whose pivot is not positive, or at which
/// it was stopped: what is in `values` is no factor then. `updates` is room that may serve others
/// later. The team of this thread does it, and however many they are, with the same bits on the
/// same kind of processor. Precondition: the pattern is that of the symbolic factor. Throws
/// std::bad_alloc.
int factorize(const SymbolicFactor& factor, const SparseSymmetric& matrix, double shift,
              double* values, Buffer<double>& updates, const std::stop_token& token = {});

}  // namespace foldless
