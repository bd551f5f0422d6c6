// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <stop_token>

#include "core/linear/buffer.h"
#include "core/linear/half_factor.h"
#include "core/linear/symbolic_factor.h"

namespace foldless {

/// The Cholesky factor of matrix + shift·I by the multifrontal method [Liu92] into `values`, which
/// have room for factor.values, with the inverse of its diagonal on the diagonal. Returns the
/// number of columns, or one, in the order of elimination, whose pivot is not positive or too large
/// for a value, or at which it was stopped: what is in `values` is no factor then. `room` is used
/// meanwhile and may serve others later. The team of this thread does it, and however many they
/// are, with the same bits on the same kind of processor. Precondition: the pattern is that of the
/// symbolic factor. Throws std::bad_alloc.
int factorize(const SymbolicFactor& factor, const SparseSymmetric& matrix, double shift,
              double* values, Buffer<std::byte>& room, const std::stop_token& token = {});

/// The same, each panel of which is rounded as soon as its front is done, as to_single_precision()
/// does it.
int factorize(const SymbolicFactor& factor, const SparseSymmetric& matrix, double shift,
              float* single, Buffer<std::byte>& room, const std::stop_token& token = {});

/// The same made in single precision and rounded to half. Precondition:
/// solves_in_single_precision().
int factorize(const SymbolicFactor& factor, const SparseSymmetric& matrix, double shift,
              HalfFactor& half, Buffer<std::byte>& room, const std::stop_token& token = {});

}  // namespace foldless
