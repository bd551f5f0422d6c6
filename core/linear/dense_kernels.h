// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace foldless {

/// Columns of a dense matrix and what is taken off them: for i < rows, j < columns
///   target(i, j) −= Σ_k left(i, k) right(j, k),   k < terms.
struct ColumnStrip {
  double* target;       ///< column after column
  int target_stride;    ///< from one column to the next
  const double* left;   ///< columns k, each of `rows` values
  const double* right;  ///< columns k, each of `columns` values
  int stride;           ///< of both, from one k to the next
  int terms;            ///< ≥ 0
  int rows;             ///< an even number
  int columns;          ///< 2 or 4
};

/// The inner loops of a dense Cholesky factorization, as one kind of processor does them best.
struct DenseKernels {
  const char* name;
  void (*subtract)(const ColumnStrip& strip);
  /// The same, but the target counts as zero before.
  void (*set_negative)(const ColumnStrip& strip);
  /// subtract(), and then every row x of the target becomes T⁻¹ x: T is the lower triangle of
  /// order `columns` at `triangle`, as far apart as the target's columns, with its diagonal
  /// inverted.
  void (*subtract_and_solve)(const ColumnStrip& strip, const double* triangle);
};

/// Those that every processor has.
extern const DenseKernels plain_kernels;
/// Those for other instructions; null where the program or the processor does not have them. They
/// multiply and subtract with one rounding, so that AVX2 and AVX-512 have the bits of each other
/// and not those of plain_kernels.
const DenseKernels* avx2_kernels();    ///< AVX2 and FMA
const DenseKernels* avx512_kernels();  ///< AVX-512, where it does not cost a lower clock
const DenseKernels* neon_kernels();    ///< every ARM processor of 64 bits
/// The best that this processor has.
const DenseKernels& dense_kernels();

}  // namespace foldless
