// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace foldless {

/// Columns of a dense matrix and what is taken off them: for i < rows, j < columns
///   target(i, j) −= Σ_k left(i, k) right(j, k),   k < terms.
template <class Value>
struct ColumnStrip {
  Value* target;       ///< column after column
  int target_stride;   ///< from one column to the next
  const Value* left;   ///< columns k, each of `rows` values
  const Value* right;  ///< columns k, each of `columns` values
  int stride;          ///< of both, from one k to the next
  int terms;           ///< ≥ 0
  int rows;            ///< an even number
  int columns;         ///< 2 or 4
};

/// The inner loops of a dense Cholesky factorization, as one kind of processor does them best. A
/// Value is a double or a float.
template <class Value>
struct DenseKernels {
  const char* name;
  void (*subtract)(const ColumnStrip<Value>& strip);
  /// The same, but the target counts as zero before.
  void (*set_negative)(const ColumnStrip<Value>& strip);
  /// subtract(), and then every row x of the target becomes T⁻¹ x: T is the lower triangle of
  /// order `columns` at `triangle`, as far apart as the target's columns, with its diagonal
  /// inverted.
  void (*subtract_and_solve)(const ColumnStrip<Value>& strip, const Value* triangle);
};

/// Those that every processor has.
template <class Value>
const DenseKernels<Value>& plain_kernels();
/// Those for other instructions; null where the program or the processor does not have them. They
/// multiply and subtract with one rounding, so that AVX2 and AVX-512 have the bits of each other
/// and not those of plain_kernels().
/// AVX2 and FMA.
template <class Value>
const DenseKernels<Value>* avx2_kernels();
/// AVX-512, where it does not cost a lower clock.
template <class Value>
const DenseKernels<Value>* avx512_kernels();
/// Every ARM processor of 64 bits, for doubles alone.
template <class Value>
const DenseKernels<Value>* neon_kernels();
/// The best that this processor has.
template <class Value>
const DenseKernels<Value>& dense_kernels();

}  // namespace foldless
