// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <stop_token>

#include "core/linear/buffer.h"
#include "core/linear/symbolic_factor.h"

namespace foldless {

/// The Cholesky factor of matrix + shift·I by the multifrontal method [Liu92] into `values`, which
/// have room for factor.values, with the inverse of its diagonal on the diagonal and, where a Value
/// is a float, zero above it. Returns the number of columns, or one, in the order of elimination,
/// whose pivot is not positive or too large for a Value, or at which it was stopped: what is in
/// `values` is no factor then. `updates` is room that may serve others later. The team of this
/// thread does it, and however many they are, with the same bits on the same kind of processor.
/// Precondition: the pattern is that of the symbolic factor. Throws std::bad_alloc.
template <class Value>
int factorize(const SymbolicFactor& factor, const SparseSymmetric& matrix, double shift,
              Value* values, Buffer<std::byte>& updates, const std::stop_token& token = {});

}  // namespace foldless
