// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/half_precision_solve.h"

#ifdef __x86_64__
#include <immintrin.h>
#endif

#include <algorithm>
#include <cstddef>

#include "core/linear/node_vectors.h"
#include "core/linear/single_precision_solve.h"
#include "core/linear/sweep.h"

namespace foldless {

#ifdef __x86_64__

namespace {

#define FOLDLESS_F16C __attribute__((target("avx2,fma,f16c"))) inline

static_assert(kStripRows <= kSingleOverrun, "rows of the last strip that are not there");

FOLDLESS_F16C __m256 load_strip(const std::uint16_t* strip) {
  return _mm256_cvtph_ps(_mm_loadu_si128(reinterpret_cast<const __m128i*>(strip)));
}

/// The columns' own unknowns are solved for.
template <int Columns>
FOLDLESS_F16C void forward_head(const float* head, float* own) {
  for (int c = 0; c < Columns; ++c, head += kStripColumns)
    for (int d = 1; c + d < Columns; ++d) own[c + d] -= head[d] * own[c];
}

template <int Columns>
FOLDLESS_F16C void backward_head(const float* head, float* own) {
  for (int c = Columns - 1; c >= 0; --c)
    for (int d = 1; c + d < Columns; ++d) own[c] -= head[c * kStripColumns + d] * own[c + d];
}

/// What the columns add to eight rows is taken off.
template <int Columns>
FOLDLESS_F16C __m256 without_columns(__m256 rows, const std::uint16_t* strip,
                                     const __m256 (&x)[Columns]) {
  for (int c = 0; c < Columns; ++c)
    rows = _mm256_fnmadd_ps(load_strip(strip + c * kStripRows), x[c], rows);
  return rows;
}

template <int Columns>
FOLDLESS_F16C void add_products(const std::uint16_t* strip, __m256 known, __m256 (&sums)[Columns]) {
  ask_for_earlier(strip);
  for (int c = 0; c < Columns; ++c)
    sums[c] = _mm256_fmadd_ps(load_strip(strip + c * kStripRows), known, sums[c]);
}

FOLDLESS_F16C __m128 sum_of_halves(__m256 v) {
  return _mm_add_ps(_mm256_castps256_ps128(v), _mm256_extractf128_ps(v, 1));
}

/// Takes the sums of the vectors' values off.
FOLDLESS_F16C void subtract_sums(const __m256 (&sums)[2], float* own) {
  const __m128 pairs = sum_of_halves(_mm256_hadd_ps(sums[0], sums[1]));
  own[0] -= _mm_cvtss_f32(pairs) + _mm_cvtss_f32(_mm_shuffle_ps(pairs, pairs, 1));
  const __m128 second = _mm_movehl_ps(pairs, pairs);
  own[1] -= _mm_cvtss_f32(second) + _mm_cvtss_f32(_mm_shuffle_ps(second, second, 1));
}

FOLDLESS_F16C void subtract_sums(const __m256 (&sums)[4], float* own) {
  const __m256 pairs =
      _mm256_hadd_ps(_mm256_hadd_ps(sums[0], sums[1]), _mm256_hadd_ps(sums[2], sums[3]));
  _mm_storeu_ps(own, _mm_sub_ps(_mm_loadu_ps(own), sum_of_halves(pairs)));
}

/// Some columns of a wide supernode; `own` is where these are in the front's scratch space, and so
/// many rows follow.
template <int Columns>
FOLDLESS_F16C void forward_group(const std::uint16_t* strip, const float* head, float* own,
                                 int below) {
  forward_head<Columns>(head, own);
  __m256 x[Columns];
  for (int c = 0; c < Columns; ++c) x[c] = _mm256_set1_ps(own[c]);
  for (float *row = own + Columns, *end = row + below; row < end;
       row += kStripRows, strip += Columns * kStripRows)
    _mm256_storeu_ps(row, without_columns(_mm256_loadu_ps(row), strip, x));
}

template <int Columns>
FOLDLESS_F16C void backward_group(const std::uint16_t* strip, const float* head, float* own,
                                  int below) {
  __m256 sums[Columns];
  for (__m256& sum : sums) sum = _mm256_setzero_ps();
  for (const float *row = own + Columns, *end = row + below; row < end;
       row += kStripRows, strip += Columns * kStripRows)
    add_products(strip, _mm256_loadu_ps(row), sums);
  subtract_sums(sums, own);
  backward_head<Columns>(head, own);
}

/// What is needed of a supernode.
struct HalfSupernode {
  const Supernode& s;
  const int* node;  ///< of every two rows below
  const std::uint16_t* strip;
  const float* head;
};

/// A supernode whose columns all go together works where its unknowns are.
template <int Columns>
FOLDLESS_F16C void forward_narrow(const HalfSupernode& of, float* all) {
  float* own = all + of.s.first;
  forward_head<Columns>(of.head, own);
  __m256 x[Columns];
  for (int c = 0; c < Columns; ++c) x[c] = _mm256_set1_ps(own[c]);
  const int* node = of.node;
  const std::uint16_t* strip = of.strip;
  for (int left = of.s.below / 2; left > 0;
       left -= kStripRows / 2, node += kStripRows / 2, strip += Columns * kStripRows)
    store_nodes(without_columns(load_nodes(all, node, left), strip, x), all, node, left);
  for (int c = 0; c < Columns; ++c) own[c] *= of.head[c * kStripColumns];
}

template <int Columns>
FOLDLESS_F16C void backward_narrow(const HalfSupernode& of, float* all) {
  __m256 sums[Columns];
  for (__m256& sum : sums) sum = _mm256_setzero_ps();
  const int* node = of.node;
  const std::uint16_t* strip = of.strip;
  for (int left = of.s.below / 2; left > 0;
       left -= kStripRows / 2, node += kStripRows / 2, strip += Columns * kStripRows)
    add_products(strip, load_nodes(all, node, left), sums);
  float* own = all + of.s.first;
  subtract_sums(sums, own);
  backward_head<Columns>(of.head, own);
}

/// x becomes D⁻¹ L⁻¹ x.
FOLDLESS_F16C void forward_half(const HalfSupernode& of, float* x, float* work) {
  const Supernode& s = of.s;
  if (s.columns == 2) return forward_narrow<2>(of, x);
  if (s.columns == 4) return forward_narrow<4>(of, x);
  std::copy_n(x + s.first, s.columns, work);
  std::fill_n(work + s.columns, static_cast<std::size_t>(s.below) + kStripRows, 0.0F);
  const std::uint16_t* strip = of.strip;
  for (int j = 0; j < s.columns; j += kStripColumns) {
    const int columns = strip_columns(s, j), below = s.rows() - j - columns;
    const float* head = of.head + static_cast<std::ptrdiff_t>(j) * kStripColumns;
    if (columns == kStripColumns)
      forward_group<4>(strip, head, work + j, below);
    else
      forward_group<2>(strip, head, work + j, below);
    strip += strip_values(columns, below);
  }
  for (int c = 0; c < s.columns; ++c)
    x[s.first + c] = work[c] * of.head[static_cast<std::ptrdiff_t>(c) * kStripColumns];
  const float* from = work + s.columns;
  for (int i = 0; i < s.below / 2; ++i, from += 2) {
    float* to = x + 2 * static_cast<std::ptrdiff_t>(of.node[i]);
    to[0] += from[0];
    to[1] += from[1];
  }
}

/// x becomes L⁻ᵀ x; `end` is where the strips end.
FOLDLESS_F16C void backward_half(const HalfSupernode& of, const std::uint16_t* end, float* x,
                                 float* work) {
  const Supernode& s = of.s;
  if (s.columns == 2) return backward_narrow<2>(of, x);
  if (s.columns == 4) return backward_narrow<4>(of, x);
  std::copy_n(x + s.first, s.columns, work);
  _mm256_storeu_ps(work + s.rows(), _mm256_setzero_ps());
  const int* node = of.node;
  for (int i = 0; i < s.below; i += kStripRows, node += kStripRows / 2)
    _mm256_storeu_ps(work + s.columns + i, load_nodes(x, node, (s.below - i) / 2));
  for (int j = (s.columns - 1) / kStripColumns * kStripColumns; j >= 0; j -= kStripColumns) {
    const int columns = strip_columns(s, j), below = s.rows() - j - columns;
    end -= strip_values(columns, below);
    const float* head = of.head + static_cast<std::ptrdiff_t>(j) * kStripColumns;
    if (columns == kStripColumns)
      backward_group<4>(end, head, work + j, below);
    else
      backward_group<2>(end, head, work + j, below);
  }
  std::copy_n(work, s.columns, x + s.first);
}

#undef FOLDLESS_F16C

}  // namespace

void triangular_solve_half(const SymbolicFactor& factor, const HalfFactor& half, float* x,
                           float* work) {
  const std::uint16_t* strips = half.strips.data();
  const auto start_of = [&](const Supernode& s) {
    return half.start.data() + number_in(factor, s);
  };
  const auto parts_of = [&](const Supernode& s) {
    return HalfSupernode{s, factor.solve_rows.data() + s.row_start, strips + *start_of(s),
                         half.heads.data() + kStripColumns * static_cast<std::size_t>(s.first)};
  };
  const auto forward = [&](const Supernode& s, float* of, float* scratch) {
    forward_half(parts_of(s), of, scratch);
  };
  const auto backward = [&](const Supernode& s, float* of, float* scratch) {
    backward_half(parts_of(s), strips + *(start_of(s) + 1), of, scratch);
  };
  sweep(factor, SweptVector<float>{x, work, kSingleOverrun}, forward, backward);
}

#else

void triangular_solve_half(const SymbolicFactor&, const HalfFactor&, float*, float*) {}

#endif

}  // namespace foldless
