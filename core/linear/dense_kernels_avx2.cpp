// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/dense_kernels.h"

#ifdef __x86_64__

#include <immintrin.h>

#define FOLDLESS_KERNEL __attribute__((target("avx2,fma"), always_inline)) inline
#include "core/linear/dense_tile.h"

namespace foldless {
namespace {

/// Four rows in a register, and two.
struct FourRows {
  static constexpr int kRows = 4;
  __m256d v;
  FOLDLESS_KERNEL static FourRows zero() { return {_mm256_setzero_pd()}; }
  FOLDLESS_KERNEL static FourRows load(const double* p, AllRows) { return {_mm256_loadu_pd(p)}; }
  FOLDLESS_KERNEL static FourRows all(const double* p) { return {_mm256_broadcast_sd(p)}; }
  FOLDLESS_KERNEL void store(double* p, AllRows) const { _mm256_storeu_pd(p, v); }
  FOLDLESS_KERNEL void subtract(FourRows a, FourRows b) { v = _mm256_fnmadd_pd(a.v, b.v, v); }
  FOLDLESS_KERNEL void multiply(FourRows a) { v = _mm256_mul_pd(a.v, v); }
};
struct TwoRows {
  static constexpr int kRows = 2;
  __m128d v;
  FOLDLESS_KERNEL static TwoRows zero() { return {_mm_setzero_pd()}; }
  FOLDLESS_KERNEL static TwoRows load(const double* p, AllRows) { return {_mm_loadu_pd(p)}; }
  FOLDLESS_KERNEL static TwoRows all(const double* p) { return {_mm_loaddup_pd(p)}; }
  FOLDLESS_KERNEL void store(double* p, AllRows) const { _mm_storeu_pd(p, v); }
  FOLDLESS_KERNEL void subtract(TwoRows a, TwoRows b) { v = _mm_fnmadd_pd(a.v, b.v, v); }
  FOLDLESS_KERNEL void multiply(TwoRows a) { v = _mm_mul_pd(a.v, v); }
};

template <int Columns, StripKind Kind>
FOLDLESS_KERNEL void do_strip(const StripAndTriangle& t) {
  const int rows = t.strip.rows;
  int i = 0;
  for (; i + 12 <= rows; i += 12) do_tile<FourRows, 3, Columns, Kind>(t, i, AllRows{});
  if (i + 8 <= rows) {
    do_tile<FourRows, 2, Columns, Kind>(t, i, AllRows{});
    i += 8;
  } else if (i + 4 <= rows) {
    do_tile<FourRows, 1, Columns, Kind>(t, i, AllRows{});
    i += 4;
  }
  if (i < rows) do_tile<TwoRows, 1, Columns, Kind>(t, i, AllRows{});
}

template <StripKind Kind>
FOLDLESS_KERNEL void do_strip(const StripAndTriangle& t) {
  if (t.strip.columns == 4)
    do_strip<4, Kind>(t);
  else
    do_strip<2, Kind>(t);
}

__attribute__((target("avx2,fma"))) void avx2_subtract(const ColumnStrip& s) {
  do_strip<StripKind::subtract>({s, nullptr});
}
__attribute__((target("avx2,fma"))) void avx2_set_negative(const ColumnStrip& s) {
  do_strip<StripKind::set_negative>({s, nullptr});
}
__attribute__((target("avx2,fma"))) void avx2_subtract_and_solve(const ColumnStrip& s,
                                                                 const double* triangle) {
  do_strip<StripKind::solve>({s, triangle});
}

const DenseKernels kernels_for_avx2 = {"AVX2", avx2_subtract, avx2_set_negative,
                                       avx2_subtract_and_solve};

}  // namespace

const DenseKernels* avx2_kernels() {
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") ? &kernels_for_avx2
                                                                         : nullptr;
}

}  // namespace foldless

#undef FOLDLESS_KERNEL

#else

namespace foldless {
const DenseKernels* avx2_kernels() { return nullptr; }
}  // namespace foldless

#endif
