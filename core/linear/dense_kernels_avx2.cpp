// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/dense_kernels.h"

#ifdef __x86_64__
#include <immintrin.h>
#endif

#include <cstddef>

namespace foldless {

#ifdef __x86_64__

namespace {

#define FOLDLESS_AVX2 __attribute__((target("avx2,fma"), always_inline)) inline

/// Four rows in a register, and the last two of a strip.
struct FourRows {
  static constexpr int kRows = 4;
  __m256d v;
  FOLDLESS_AVX2 static FourRows zero() { return {_mm256_setzero_pd()}; }
  FOLDLESS_AVX2 static FourRows load(const double* p) { return {_mm256_loadu_pd(p)}; }
  FOLDLESS_AVX2 static FourRows all(const double* p) { return {_mm256_broadcast_sd(p)}; }
  FOLDLESS_AVX2 void store(double* p) const { _mm256_storeu_pd(p, v); }
  FOLDLESS_AVX2 void subtract(FourRows a, FourRows b) { v = _mm256_fnmadd_pd(a.v, b.v, v); }
  FOLDLESS_AVX2 void multiply(FourRows a) { v = _mm256_mul_pd(a.v, v); }
};
struct TwoRows {
  static constexpr int kRows = 2;
  __m128d v;
  FOLDLESS_AVX2 static TwoRows zero() { return {_mm_setzero_pd()}; }
  FOLDLESS_AVX2 static TwoRows load(const double* p) { return {_mm_loadu_pd(p)}; }
  FOLDLESS_AVX2 static TwoRows all(const double* p) { return {_mm_loaddup_pd(p)}; }
  FOLDLESS_AVX2 void store(double* p) const { _mm_storeu_pd(p, v); }
  FOLDLESS_AVX2 void subtract(TwoRows a, TwoRows b) { v = _mm_fnmadd_pd(a.v, b.v, v); }
  FOLDLESS_AVX2 void multiply(TwoRows a) { v = _mm_mul_pd(a.v, v); }
};

/// What is known of a strip when it is compiled.
enum class StripKind { subtract, set_negative, solve };

/// Lanes registers of rows × Columns from row `i` on.
template <class Lane, int Lanes, int Columns, StripKind Kind>
FOLDLESS_AVX2 void avx2_tile(const ColumnStrip& s, const double* triangle, int i) {
  Lane value[Columns][Lanes];
  double* target = s.target + i;
  for (int c = 0; c < Columns; ++c)
    for (int r = 0; r < Lanes; ++r)
      value[c][r] = Kind == StripKind::set_negative
                        ? Lane::zero()
                        : Lane::load(target + static_cast<std::ptrdiff_t>(c) * s.target_stride +
                                     r * Lane::kRows);
  const double* left = s.left + i;
  const double* right = s.right;
  for (int k = 0; k < s.terms; ++k, left += s.stride, right += s.stride) {
    Lane rows[Lanes];
    for (int r = 0; r < Lanes; ++r) rows[r] = Lane::load(left + r * Lane::kRows);
    for (int c = 0; c < Columns; ++c) {
      const Lane factor = Lane::all(right + c);
      for (int r = 0; r < Lanes; ++r) value[c][r].subtract(rows[r], factor);
    }
  }
  if constexpr (Kind == StripKind::solve)
    for (int c = 0; c < Columns; ++c) {
      const double* column = triangle + static_cast<std::ptrdiff_t>(c) * s.target_stride;
      for (int r = 0; r < Lanes; ++r) value[c][r].multiply(Lane::all(column + c));
      for (int d = c + 1; d < Columns; ++d)
        for (int r = 0; r < Lanes; ++r) value[d][r].subtract(value[c][r], Lane::all(column + d));
    }
  for (int c = 0; c < Columns; ++c)
    for (int r = 0; r < Lanes; ++r)
      value[c][r].store(target + static_cast<std::ptrdiff_t>(c) * s.target_stride +
                        r * Lane::kRows);
}

template <int Columns, StripKind Kind>
FOLDLESS_AVX2 void avx2_strip(const ColumnStrip& s, const double* triangle) {
  int i = 0;
  for (; i + 12 <= s.rows; i += 12) avx2_tile<FourRows, 3, Columns, Kind>(s, triangle, i);
  if (i + 8 <= s.rows) {
    avx2_tile<FourRows, 2, Columns, Kind>(s, triangle, i);
    i += 8;
  } else if (i + 4 <= s.rows) {
    avx2_tile<FourRows, 1, Columns, Kind>(s, triangle, i);
    i += 4;
  }
  if (i < s.rows) avx2_tile<TwoRows, 1, Columns, Kind>(s, triangle, i);
}

template <StripKind Kind>
FOLDLESS_AVX2 void avx2_strip(const ColumnStrip& s, const double* triangle) {
  if (s.columns == 4)
    avx2_strip<4, Kind>(s, triangle);
  else
    avx2_strip<2, Kind>(s, triangle);
}

__attribute__((target("avx2,fma"))) void avx2_subtract(const ColumnStrip& s) {
  avx2_strip<StripKind::subtract>(s, nullptr);
}
__attribute__((target("avx2,fma"))) void avx2_set_negative(const ColumnStrip& s) {
  avx2_strip<StripKind::set_negative>(s, nullptr);
}
__attribute__((target("avx2,fma"))) void avx2_subtract_and_solve(const ColumnStrip& s,
                                                                 const double* triangle) {
  avx2_strip<StripKind::solve>(s, triangle);
}

#undef FOLDLESS_AVX2

const DenseKernels kernels_for_avx2 = {"AVX2", avx2_subtract, avx2_set_negative,
                                       avx2_subtract_and_solve};

}  // namespace

const DenseKernels* avx2_kernels() {
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") ? &kernels_for_avx2
                                                                         : nullptr;
}

#else

const DenseKernels* avx2_kernels() { return nullptr; }

#endif

}  // namespace foldless
