// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/dense_kernels.h"

#ifdef __x86_64__

#include <immintrin.h>

#define FOLDLESS_KERNEL __attribute__((target("avx512f"), always_inline)) inline
#include "core/linear/dense_tile.h"

namespace foldless {
namespace {

/// Eight rows in a register, or the first of them that `mask` names.
struct EightRows {
  static constexpr int kRows = 8;
  __m512d v;
  FOLDLESS_KERNEL static EightRows zero() { return {_mm512_setzero_pd()}; }
  FOLDLESS_KERNEL static EightRows load(const double* p, AllRows) { return {_mm512_loadu_pd(p)}; }
  FOLDLESS_KERNEL static EightRows load(const double* p, __mmask8 mask) {
    return {_mm512_maskz_loadu_pd(mask, p)};
  }
  FOLDLESS_KERNEL static EightRows all(const double* p) { return {_mm512_set1_pd(*p)}; }
  FOLDLESS_KERNEL void store(double* p, AllRows) const { _mm512_storeu_pd(p, v); }
  FOLDLESS_KERNEL void store(double* p, __mmask8 mask) const { _mm512_mask_storeu_pd(p, mask, v); }
  FOLDLESS_KERNEL void subtract(EightRows a, EightRows b) { v = _mm512_fnmadd_pd(a.v, b.v, v); }
  FOLDLESS_KERNEL void multiply(EightRows a) { v = _mm512_mul_pd(a.v, v); }
};

template <int Columns, StripKind Kind>
FOLDLESS_KERNEL void do_strip(const StripAndTriangle& t) {
  const int rows = t.strip.rows;
  int i = 0;
  for (; i + 24 <= rows; i += 24) do_tile<EightRows, 3, Columns, Kind>(t, i, AllRows{});
  const int rest = rows - i;
  const auto mask = static_cast<__mmask8>(0xffU >> (-rest & 7));
  if (rest > 16)
    do_tile<EightRows, 3, Columns, Kind>(t, i, mask);
  else if (rest > 8)
    do_tile<EightRows, 2, Columns, Kind>(t, i, mask);
  else if (rest > 0)
    do_tile<EightRows, 1, Columns, Kind>(t, i, mask);
}

template <StripKind Kind>
FOLDLESS_KERNEL void do_strip(const StripAndTriangle& t) {
  if (t.strip.columns == 4)
    do_strip<4, Kind>(t);
  else
    do_strip<2, Kind>(t);
}

#define FOLDLESS_AVX512 __attribute__((target("avx512f")))

FOLDLESS_AVX512 void avx512_subtract(const ColumnStrip& s) {
  do_strip<StripKind::subtract>({s, nullptr});
}
FOLDLESS_AVX512 void avx512_set_negative(const ColumnStrip& s) {
  do_strip<StripKind::set_negative>({s, nullptr});
}
FOLDLESS_AVX512 void avx512_subtract_and_solve(const ColumnStrip& s, const double* triangle) {
  do_strip<StripKind::solve>({s, triangle});
}

const DenseKernels kernels_for_avx512 = {"AVX-512", avx512_subtract, avx512_set_negative,
                                         avx512_subtract_and_solve};

}  // namespace

const DenseKernels* avx512_kernels() {
  // The first generation with AVX-512 lowers its clock for it; the later ones have VBMI2 too.
  const bool is_worth_while =
      __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vbmi2");
  return is_worth_while && avx2_kernels() ? &kernels_for_avx512 : nullptr;
}

}  // namespace foldless

#undef FOLDLESS_KERNEL
#undef FOLDLESS_AVX512

#else

namespace foldless {
const DenseKernels* avx512_kernels() { return nullptr; }
}  // namespace foldless

#endif
