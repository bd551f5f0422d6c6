// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/dense_kernels.h"

#ifdef __x86_64__

#include <immintrin.h>

#define FOLDLESS_KERNEL __attribute__((target("avx512f"), always_inline)) inline
#include "core/linear/dense_tile.h"

namespace foldless {
namespace {

/// A register of eight doubles, or the first of them that `mask` names.
struct EightDoubles {
  using Value = double;
  using Mask = __mmask8;
  static constexpr int kRows = 8;
  __m512d v;
  FOLDLESS_KERNEL static EightDoubles zero() { return {_mm512_setzero_pd()}; }
  FOLDLESS_KERNEL static EightDoubles load(const double* p, AllRows) {
    return {_mm512_loadu_pd(p)};
  }
  FOLDLESS_KERNEL static EightDoubles load(const double* p, Mask mask) {
    return {_mm512_maskz_loadu_pd(mask, p)};
  }
  FOLDLESS_KERNEL static EightDoubles all(const double* p) { return {_mm512_set1_pd(*p)}; }
  FOLDLESS_KERNEL void store(double* p, AllRows) const { _mm512_storeu_pd(p, v); }
  FOLDLESS_KERNEL void store(double* p, Mask mask) const { _mm512_mask_storeu_pd(p, mask, v); }
  FOLDLESS_KERNEL void subtract(EightDoubles a, EightDoubles b) {
    v = _mm512_fnmadd_pd(a.v, b.v, v);
  }
  FOLDLESS_KERNEL void multiply(EightDoubles a) { v = _mm512_mul_pd(a.v, v); }
};
/// The same of sixteen floats.
struct SixteenFloats {
  using Value = float;
  using Mask = __mmask16;
  static constexpr int kRows = 16;
  __m512 v;
  FOLDLESS_KERNEL static SixteenFloats zero() { return {_mm512_setzero_ps()}; }
  FOLDLESS_KERNEL static SixteenFloats load(const float* p, AllRows) {
    return {_mm512_loadu_ps(p)};
  }
  FOLDLESS_KERNEL static SixteenFloats load(const float* p, Mask mask) {
    return {_mm512_maskz_loadu_ps(mask, p)};
  }
  FOLDLESS_KERNEL static SixteenFloats all(const float* p) { return {_mm512_set1_ps(*p)}; }
  FOLDLESS_KERNEL void store(float* p, AllRows) const { _mm512_storeu_ps(p, v); }
  FOLDLESS_KERNEL void store(float* p, Mask mask) const { _mm512_mask_storeu_ps(p, mask, v); }
  FOLDLESS_KERNEL void subtract(SixteenFloats a, SixteenFloats b) {
    v = _mm512_fnmadd_ps(a.v, b.v, v);
  }
  FOLDLESS_KERNEL void multiply(SixteenFloats a) { v = _mm512_mul_ps(a.v, v); }
};

template <class Lane, int Columns, StripKind Kind>
FOLDLESS_KERNEL void do_strip(const StripAndTriangle<typename Lane::Value>& t) {
  constexpr int kRows = Lane::kRows;
  const int rows = t.strip.rows;
  int i = 0;
  for (; i + 3 * kRows <= rows; i += 3 * kRows) do_tile<Lane, 3, Columns, Kind>(t, i, AllRows{});
  const int rest = rows - i;
  const auto mask = static_cast<typename Lane::Mask>(((1U << kRows) - 1) >> (-rest & (kRows - 1)));
  if (rest > 2 * kRows)
    do_tile<Lane, 3, Columns, Kind>(t, i, mask);
  else if (rest > kRows)
    do_tile<Lane, 2, Columns, Kind>(t, i, mask);
  else if (rest > 0)
    do_tile<Lane, 1, Columns, Kind>(t, i, mask);
}

template <class Lane, StripKind Kind>
FOLDLESS_KERNEL void do_strip(const StripAndTriangle<typename Lane::Value>& t) {
  if (t.strip.columns == 4)
    do_strip<Lane, 4, Kind>(t);
  else
    do_strip<Lane, 2, Kind>(t);
}

#define FOLDLESS_AVX512 __attribute__((target("avx512f")))

template <class Lane>
FOLDLESS_AVX512 void avx512_subtract(const ColumnStrip<typename Lane::Value>& s) {
  do_strip<Lane, StripKind::subtract>({s, nullptr});
}
template <class Lane>
FOLDLESS_AVX512 void avx512_set_negative(const ColumnStrip<typename Lane::Value>& s) {
  do_strip<Lane, StripKind::set_negative>({s, nullptr});
}
template <class Lane>
FOLDLESS_AVX512 void avx512_subtract_and_solve(const ColumnStrip<typename Lane::Value>& s,
                                               const typename Lane::Value* triangle) {
  do_strip<Lane, StripKind::solve>({s, triangle});
}

template <class Lane>
const DenseKernels<typename Lane::Value>* avx512_kernels_of() {
  static constexpr DenseKernels<typename Lane::Value> kKernels = {
      "AVX-512", avx512_subtract<Lane>, avx512_set_negative<Lane>, avx512_subtract_and_solve<Lane>};
  // The first generation with AVX-512 lowers its clock for it; the later ones have VBMI2 too.
  const bool is_worth_while =
      __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vbmi2");
  return is_worth_while && avx2_kernels<typename Lane::Value>() ? &kKernels : nullptr;
}

}  // namespace

template <>
const DenseKernels<double>* avx512_kernels() {
  return avx512_kernels_of<EightDoubles>();
}
template <>
const DenseKernels<float>* avx512_kernels() {
  return avx512_kernels_of<SixteenFloats>();
}

}  // namespace foldless

#undef FOLDLESS_KERNEL
#undef FOLDLESS_AVX512

#else

namespace foldless {
template <>
const DenseKernels<double>* avx512_kernels() {
  return nullptr;
}
template <>
const DenseKernels<float>* avx512_kernels() {
  return nullptr;
}
}  // namespace foldless

#endif
