// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <immintrin.h>

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

}  // namespace
}  // namespace foldless
