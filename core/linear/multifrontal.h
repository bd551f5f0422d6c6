// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>

#include "core/linear/symbolic_factor.h"

namespace foldless {

/// Values that are not initialised.
template <class Value>
class Buffer {
 public:
  Value* data() { return values_.get(); }
  const Value* data() const { return values_.get(); }
  /// Makes room; what was in it is lost where it was too small. Throws std::bad_alloc.
  void reserve(std::size_t size) {
    if (size <= size_) return;
    values_.reset();
    size_ = 0;
    values_ = std::make_unique_for_overwrite<Value[]>(size);
    size_ = size;
  }

 private:
  std::unique_ptr<Value[]> values_;
  std::size_t size_ = 0;
};

/// Room for the update matrices of a factorization; may serve others later.
struct UpdateStacks {
  Buffer<double> stack[2];
};

/// The Cholesky factor of matrix + shift·I by the multifrontal method [Liu92] into `values`, which
/// have room for factor.values, with the inverse of its diagonal on the diagonal. Returns the
/// number of columns, or the first, in the order of elimination, whose pivot is not positive: what
/// is in `values` is no factor then. One thread; the same bits whenever the same processor does it.
/// Precondition: the pattern is that of the symbolic factor. Throws std::bad_alloc.
int factorize(const SymbolicFactor& factor, const SparseSymmetric& matrix, double shift,
              double* values, UpdateStacks& stacks);

}  // namespace foldless
