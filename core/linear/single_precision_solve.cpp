// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/single_precision_solve.h"

#ifdef __x86_64__
#include <cpuid.h>
#include <immintrin.h>
#endif

#include <algorithm>
#include <cstddef>

#include "core/linear/node_vectors.h"
#include "core/linear/sweep.h"

namespace foldless {

void to_single_precision(const Supernode& s, const double* panel, float* single) {
  constexpr std::ptrdiff_t kValuesTogether = 65'536;
  each_in_ranges(s.columns, 1 + kValuesTogether / s.rows(), [&](std::ptrdiff_t j) {
    const double* from = panel + j * s.rows();
    float* to = single + j * s.rows();
    std::fill_n(to, j, 0.0F);
    for (std::ptrdiff_t i = j; i < s.rows(); ++i) to[i] = static_cast<float>(from[i]);
  });
}

void to_single_precision(const SymbolicFactor& factor, const double* values, float* single) {
  constexpr std::ptrdiff_t kSupernodesTogether = 500;
  each_in_ranges(static_cast<std::ptrdiff_t>(factor.supernodes.size()), kSupernodesTogether,
                 [&](std::ptrdiff_t k) {
                   const Supernode& s = factor.supernodes[static_cast<std::size_t>(k)];
                   to_single_precision(s, values + s.value_start, single + s.value_start);
                 });
}

#ifdef __x86_64__

namespace {

#define FOLDLESS_AVX2 __attribute__((target("avx2,fma"))) inline

constexpr int kLanes = 8;

/// Some columns of a panel next to each other, of which the first is the panel's column `column`.
template <int Columns>
struct SingleColumns {
  const float* value;  ///< of the first column
  int rows;
  int column;

  const float* of(int c) const { return value + static_cast<std::ptrdiff_t>(c) * rows; }
};

/// work, by rows of the panel: the first of its rows that are not done are solved for, and what
/// they add to the others is taken off.
template <int Columns>
FOLDLESS_AVX2 void forward_columns(const SingleColumns<Columns>& s, float* work) {
  __m256 x[Columns];
  float* own = work + s.column;
  for (int c = 0; c < Columns; ++c) {
    const float* column = s.of(c) + s.column;
    own[c] *= column[c];
    for (int d = c + 1; d < Columns; ++d) own[d] -= column[d] * own[c];
    x[c] = _mm256_set1_ps(own[c]);
  }
  for (int i = s.column + Columns; i < s.rows; i += kLanes) {
    __m256 sum = _mm256_loadu_ps(work + i);
    for (int c = 0; c < Columns; ++c)
      sum = _mm256_fnmadd_ps(_mm256_loadu_ps(s.of(c) + i), x[c], sum);
    _mm256_storeu_ps(work + i, sum);
  }
}

FOLDLESS_AVX2 float sum_of(__m256 v) {
  __m128 sum = _mm_add_ps(_mm256_castps256_ps128(v), _mm256_extractf128_ps(v, 1));
  sum = _mm_add_ps(sum, _mm_movehl_ps(sum, sum));
  return _mm_cvtss_f32(_mm_add_ss(sum, _mm_movehdup_ps(sum)));
}

template <int Columns>
FOLDLESS_AVX2 void backward_columns(const SingleColumns<Columns>& s, float* work) {
  __m256 sums[Columns];
  for (int c = 0; c < Columns; ++c) sums[c] = _mm256_setzero_ps();
  for (int i = s.column + Columns; i < s.rows; i += kLanes) {
    const __m256 known = _mm256_loadu_ps(work + i);
    for (int c = 0; c < Columns; ++c) {
      ask_for_earlier(s.of(c) + i);
      sums[c] = _mm256_fmadd_ps(_mm256_loadu_ps(s.of(c) + i), known, sums[c]);
    }
  }
  float* own = work + s.column;
  for (int c = Columns - 1; c >= 0; --c) {
    const float* column = s.of(c) + s.column;
    float rest = own[c] - sum_of(sums[c]);
    for (int d = c + 1; d < Columns; ++d) rest -= column[d] * own[d];
    own[c] = rest * column[c];
  }
}

/// forward_single() of a supernode of two columns, without a copy of what it works on.
FOLDLESS_AVX2 void forward_pair(const Supernode& s, const int* node, const float* a, float* x) {
  const float* b = a + s.rows();
  float* own = x + s.first;
  own[0] *= a[0];
  own[1] = (own[1] - a[1] * own[0]) * b[1];
  const __m128 xa = _mm_set1_ps(own[0]), xb = _mm_set1_ps(own[1]);
  for (int i = 2; i < s.rows(); i += 2, ++node) {
    float* to = x + 2 * static_cast<std::ptrdiff_t>(*node);
    const __m128 sum = _mm_fnmadd_ps(load_pair(a + i), xa, load_pair(to));
    _mm_storel_pi(reinterpret_cast<__m64*>(to), _mm_fnmadd_ps(load_pair(b + i), xb, sum));
  }
}

/// backward_single() of a supernode of two columns.
FOLDLESS_AVX2 void backward_pair(const Supernode& s, const int* node, const float* a, float* x) {
  const float* b = a + s.rows();
  __m128 sum_a = _mm_setzero_ps(), sum_b = _mm_setzero_ps();
  for (int i = 2; i < s.rows(); i += 2, ++node) {
    const __m128 known = load_pair(x + 2 * static_cast<std::ptrdiff_t>(*node));
    sum_a = _mm_fmadd_ps(load_pair(a + i), known, sum_a);
    sum_b = _mm_fmadd_ps(load_pair(b + i), known, sum_b);
  }
  const __m128 sums = _mm_hadd_ps(sum_a, sum_b);
  float* own = x + s.first;
  own[1] = (own[1] - _mm_cvtss_f32(_mm_movehl_ps(sums, sums))) * b[1];
  own[0] = (own[0] - _mm_cvtss_f32(sums) - a[1] * own[1]) * a[0];
}

/// x becomes L⁻¹ x.
// NOLINTNEXTLINE(readability-function-size): a kernel, which is called for every supernode
FOLDLESS_AVX2 void forward_single(const Supernode& s, const int* node, const float* value, float* x,
                                  float* work) {
  if (s.columns == 2) return forward_pair(s, node, value, x);
  const int rows = s.rows(), wide = s.columns & ~3;
  std::copy_n(x + s.first, s.columns, work);
  std::fill_n(work + s.columns, static_cast<std::size_t>(s.below) + kSingleOverrun, 0.0F);
  for (int j = 0; j < wide; j += 4)
    forward_columns<4>({value + static_cast<std::ptrdiff_t>(j) * rows, rows, j}, work);
  if (wide < s.columns)
    forward_columns<2>({value + static_cast<std::ptrdiff_t>(wide) * rows, rows, wide}, work);
  std::copy_n(work, s.columns, x + s.first);
  const float* from = work + s.columns;
  for (int i = 0; i < s.below; i += 2, ++node) {
    float* to = x + 2 * static_cast<std::ptrdiff_t>(*node);
    to[0] += from[i];
    to[1] += from[i + 1];
  }
}

/// x becomes L⁻ᵀ x.
// NOLINTNEXTLINE(readability-function-size): a kernel, which is called for every supernode
FOLDLESS_AVX2 void backward_single(const Supernode& s, const int* node, const float* value,
                                   float* x, float* work) {
  if (s.columns == 2) return backward_pair(s, node, value, x);
  const int rows = s.rows(), wide = s.columns & ~3;
  std::copy_n(x + s.first, s.columns, work);
  // In stores as wide as the loads that follow: from narrower ones they would have to wait.
  _mm256_storeu_ps(work + rows, _mm256_setzero_ps());
  for (int i = 0; i < s.below; i += kLanes, node += kLanes / 2)
    _mm256_storeu_ps(work + s.columns + i, load_nodes(x, node, (s.below - i) / 2));
  if (wide < s.columns)
    backward_columns<2>({value + static_cast<std::ptrdiff_t>(wide) * rows, rows, wide}, work);
  for (int j = wide - 4; j >= 0; j -= 4)
    backward_columns<4>({value + static_cast<std::ptrdiff_t>(j) * rows, rows, j}, work);
  std::copy_n(work, s.columns, x + s.first);
}

#undef FOLDLESS_AVX2

}  // namespace

bool solves_in_single_precision() {
  static const bool has_f16c = [] {  // clang 14 has no name for it
    unsigned eax = 0, ebx = 0, ecx = 0, edx = 0;
    return __get_cpuid(1, &eax, &ebx, &ecx, &edx) != 0 && (ecx & bit_F16C) != 0;
  }();
  return has_f16c && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}

void triangular_solve_single(const SymbolicFactor& factor, const float* single, float* x,
                             float* work) {
  const int* rows = factor.solve_rows.data();
  const auto forward = [&](const Supernode& s, float* at, float* scratch) {
    forward_single(s, rows + s.row_start, single + s.value_start, at, scratch);
  };
  const auto backward = [&](const Supernode& s, float* at, float* scratch) {
    backward_single(s, rows + s.row_start, single + s.value_start, at, scratch);
  };
  sweep(factor, SweptVector<float>{x, work, kSingleOverrun}, forward, backward);
}

#else

bool solves_in_single_precision() { return false; }
void triangular_solve_single(const SymbolicFactor&, const float*, float*, float*) {}

#endif

}  // namespace foldless
