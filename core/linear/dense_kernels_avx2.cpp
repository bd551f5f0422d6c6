// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/dense_kernels.h"

#ifdef __x86_64__

#include <immintrin.h>

#define FOLDLESS_KERNEL __attribute__((target("avx2,fma"), always_inline)) inline
#include "core/linear/dense_tile.h"

namespace foldless {
namespace {

struct FourDoubles {
  using Value = double;
  static constexpr int kRows = 4;
  __m256d v;
  FOLDLESS_KERNEL static FourDoubles zero() { return {_mm256_setzero_pd()}; }
  FOLDLESS_KERNEL static FourDoubles load(const double* p, AllRows) { return {_mm256_loadu_pd(p)}; }
  FOLDLESS_KERNEL static FourDoubles all(const double* p) { return {_mm256_broadcast_sd(p)}; }
  FOLDLESS_KERNEL void store(double* p, AllRows) const { _mm256_storeu_pd(p, v); }
  FOLDLESS_KERNEL void subtract(FourDoubles a, FourDoubles b) { v = _mm256_fnmadd_pd(a.v, b.v, v); }
  FOLDLESS_KERNEL void multiply(FourDoubles a) { v = _mm256_mul_pd(a.v, v); }
};
struct TwoDoubles {
  using Value = double;
  static constexpr int kRows = 2;
  __m128d v;
  FOLDLESS_KERNEL static TwoDoubles zero() { return {_mm_setzero_pd()}; }
  FOLDLESS_KERNEL static TwoDoubles load(const double* p, AllRows) { return {_mm_loadu_pd(p)}; }
  FOLDLESS_KERNEL static TwoDoubles all(const double* p) { return {_mm_loaddup_pd(p)}; }
  FOLDLESS_KERNEL void store(double* p, AllRows) const { _mm_storeu_pd(p, v); }
  FOLDLESS_KERNEL void subtract(TwoDoubles a, TwoDoubles b) { v = _mm_fnmadd_pd(a.v, b.v, v); }
  FOLDLESS_KERNEL void multiply(TwoDoubles a) { v = _mm_mul_pd(a.v, v); }
};

struct EightFloats {
  using Value = float;
  static constexpr int kRows = 8;
  __m256 v;
  FOLDLESS_KERNEL static EightFloats zero() { return {_mm256_setzero_ps()}; }
  FOLDLESS_KERNEL static EightFloats load(const float* p, AllRows) { return {_mm256_loadu_ps(p)}; }
  FOLDLESS_KERNEL static EightFloats all(const float* p) { return {_mm256_broadcast_ss(p)}; }
  FOLDLESS_KERNEL void store(float* p, AllRows) const { _mm256_storeu_ps(p, v); }
  FOLDLESS_KERNEL void subtract(EightFloats a, EightFloats b) { v = _mm256_fnmadd_ps(a.v, b.v, v); }
  FOLDLESS_KERNEL void multiply(EightFloats a) { v = _mm256_mul_ps(a.v, v); }
};
/// Four floats, or the first two of them.
template <int Rows>
struct FourFloats {
  using Value = float;
  static constexpr int kRows = Rows;
  __m128 v;
  FOLDLESS_KERNEL static FourFloats zero() { return {_mm_setzero_ps()}; }
  FOLDLESS_KERNEL static FourFloats load(const float* p, AllRows) {
    if constexpr (Rows == 4)
      return {_mm_loadu_ps(p)};
    else
      return {_mm_loadl_pi(_mm_setzero_ps(), reinterpret_cast<const __m64*>(p))};
  }
  FOLDLESS_KERNEL static FourFloats all(const float* p) { return {_mm_set1_ps(*p)}; }
  FOLDLESS_KERNEL void store(float* p, AllRows) const {
    if constexpr (Rows == 4)
      _mm_storeu_ps(p, v);
    else
      _mm_storel_pi(reinterpret_cast<__m64*>(p), v);
  }
  FOLDLESS_KERNEL void subtract(FourFloats a, FourFloats b) { v = _mm_fnmadd_ps(a.v, b.v, v); }
  FOLDLESS_KERNEL void multiply(FourFloats a) { v = _mm_mul_ps(a.v, v); }
};

template <int Columns, StripKind Kind>
FOLDLESS_KERNEL void do_last_rows(const StripAndTriangle<double>& t, int i) {
  if (i < t.strip.rows) do_tile<TwoDoubles, 1, Columns, Kind>(t, i, AllRows{});
}
template <int Columns, StripKind Kind>
FOLDLESS_KERNEL void do_last_rows(const StripAndTriangle<float>& t, int i) {
  if (i + 4 <= t.strip.rows) {
    do_tile<FourFloats<4>, 1, Columns, Kind>(t, i, AllRows{});
    i += 4;
  }
  if (i < t.strip.rows) do_tile<FourFloats<2>, 1, Columns, Kind>(t, i, AllRows{});
}

template <class Lane, int Columns, StripKind Kind>
FOLDLESS_KERNEL void do_strip(const StripAndTriangle<typename Lane::Value>& t) {
  constexpr int kRows = Lane::kRows;
  const int rows = t.strip.rows;
  int i = 0;
  for (; i + 3 * kRows <= rows; i += 3 * kRows) do_tile<Lane, 3, Columns, Kind>(t, i, AllRows{});
  if (i + 2 * kRows <= rows) {
    do_tile<Lane, 2, Columns, Kind>(t, i, AllRows{});
    i += 2 * kRows;
  } else if (i + kRows <= rows) {
    do_tile<Lane, 1, Columns, Kind>(t, i, AllRows{});
    i += kRows;
  }
  do_last_rows<Columns, Kind>(t, i);
}

template <class Lane, StripKind Kind>
FOLDLESS_KERNEL void do_strip(const StripAndTriangle<typename Lane::Value>& t) {
  if (t.strip.columns == 4)
    do_strip<Lane, 4, Kind>(t);
  else
    do_strip<Lane, 2, Kind>(t);
}

#define FOLDLESS_AVX2 __attribute__((target("avx2,fma")))

template <class Lane>
FOLDLESS_AVX2 void avx2_subtract(const ColumnStrip<typename Lane::Value>& s) {
  do_strip<Lane, StripKind::subtract>({s, nullptr});
}
template <class Lane>
FOLDLESS_AVX2 void avx2_set_negative(const ColumnStrip<typename Lane::Value>& s) {
  do_strip<Lane, StripKind::set_negative>({s, nullptr});
}
template <class Lane>
FOLDLESS_AVX2 void avx2_subtract_and_solve(const ColumnStrip<typename Lane::Value>& s,
                                           const typename Lane::Value* triangle) {
  do_strip<Lane, StripKind::solve>({s, triangle});
}

template <class Lane>
const DenseKernels<typename Lane::Value>* avx2_kernels_of() {
  static constexpr DenseKernels<typename Lane::Value> kKernels = {
      "AVX2", avx2_subtract<Lane>, avx2_set_negative<Lane>, avx2_subtract_and_solve<Lane>};
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") ? &kKernels : nullptr;
}

}  // namespace

template <>
const DenseKernels<double>* avx2_kernels() {
  return avx2_kernels_of<FourDoubles>();
}
template <>
const DenseKernels<float>* avx2_kernels() {
  return avx2_kernels_of<EightFloats>();
}

}  // namespace foldless

#undef FOLDLESS_KERNEL
#undef FOLDLESS_AVX2

#else

namespace foldless {
template <>
const DenseKernels<double>* avx2_kernels() {
  return nullptr;
}
template <>
const DenseKernels<float>* avx2_kernels() {
  return nullptr;
}
}  // namespace foldless

#endif
