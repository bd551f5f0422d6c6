// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/linear/dense_kernels.h"

namespace foldless {

/// Columns of a dense lower triangle and the rows below them, column after column: rows × columns,
/// rows ≥ columns, both even. What is above the diagonal is neither read nor kept.
template <class Value>
struct DensePanel {
  Value* value;
  int rows;
  int columns;
};

/// The first `columns` columns of the Cholesky factor of a symmetric matrix, in its place, with the
/// *inverse* on its diagonal. Returns the number of columns, or the first whose pivot is not > 0 or
/// too large for a Value.
template <class Value>
int factorize_panel(const DensePanel<Value>& panel, const DenseKernels<Value>& kernels);

/// How subtract_square() begins.
enum class Square { accumulate, from_zero };

/// U −= B Bᵀ, the lower triangle of U, where B are the rows of a factorized panel below its
/// columns; U is column after column, of as many rows. What is above its diagonal is not kept.
template <class Value>
void subtract_square(const DensePanel<Value>& panel, Value* U, Square start,
                     const DenseKernels<Value>& kernels);

}  // namespace foldless
