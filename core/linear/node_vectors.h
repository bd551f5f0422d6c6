// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#ifdef __x86_64__

#include <immintrin.h>

#include <cstddef>

namespace foldless {

/// The two values of a node, and zeros.
inline __m128 load_pair(const float* p) {
  return _mm_loadl_pi(_mm_setzero_ps(), reinterpret_cast<const __m64*>(p));
}

/// The values of the first four of so many nodes of x, and zeros where there are fewer.
[[gnu::target("avx2,fma")]] inline __m256 load_nodes(const float* x, const int* node, int count) {
  const auto pair = [&](int k) {
    return k < count ? load_pair(x + 2 * static_cast<std::ptrdiff_t>(node[k])) : _mm_setzero_ps();
  };
  return _mm256_set_m128(_mm_movelh_ps(pair(2), pair(3)), _mm_movelh_ps(pair(0), pair(1)));
}

/// Those of the first four of so many nodes, one or more, go to x.
[[gnu::target("avx2,fma")]] inline void store_nodes(__m256 values, float* x, const int* node,
                                                    int count) {
  const auto place = [&](int k) {
    return reinterpret_cast<__m64*>(x + 2 * static_cast<std::ptrdiff_t>(node[k]));
  };
  const __m128 first = _mm256_castps256_ps128(values), last = _mm256_extractf128_ps(values, 1);
  _mm_storel_pi(place(0), first);
  if (count > 1) _mm_storeh_pi(place(1), first);
  if (count > 2) _mm_storel_pi(place(2), last);
  if (count > 3) _mm_storeh_pi(place(3), last);
}

/// A backward solve goes from the last values of a factor to the first, some columns at a time and
/// downwards in each, so that no processor guesses which come next: asks for those that are so far
/// before what is read now.
inline void ask_for_earlier(const void* read) {
  constexpr std::ptrdiff_t kBytesBefore = 8192;
  _mm_prefetch(static_cast<const char*>(read) - kBytesBefore, _MM_HINT_T0);
}

}  // namespace foldless

#endif
