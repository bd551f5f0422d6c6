// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/half_factor.h"

#ifdef __x86_64__
#include <immintrin.h>
#endif

#include "core/threads/team.h"

namespace foldless {

#ifdef __x86_64__

namespace {

/// What is larger was rounded to infinity.
constexpr float kLargestHalf = 65504;

/// The values of the strips of a supernode's first columns.
std::size_t strips_before(const Supernode& s, int column) {
  std::size_t size = 0;
  for (int j = 0; j < column; j += kStripColumns) {
    const int columns = strip_columns(s, j);
    size += strip_values(columns, s.rows() - j - columns);
  }
  return size;
}

/// Eight values of a column of L, of which `count` are there, over its diagonal.
__attribute__((target("avx2,fma,f16c"))) inline __m128i rounded(const float* value, int count,
                                                                float inverse_diagonal) {
  alignas(32) float some[kStripRows] = {};
  if (count < kStripRows) value = std::copy_n(value, count, some) - count;
  const __m256 scaled = _mm256_mul_ps(_mm256_loadu_ps(value), _mm256_set1_ps(inverse_diagonal));
  const __m256 largest = _mm256_set1_ps(kLargestHalf);
  const __m256 kept =
      _mm256_max_ps(_mm256_min_ps(scaled, largest), _mm256_sub_ps(_mm256_setzero_ps(), largest));
  return _mm256_cvtps_ph(kept, _MM_FROUND_TO_NEAREST_INT);
}

/// Where columns that go together are kept.
struct StripPlace {
  std::uint16_t* strip;
  float* head;
};

/// Columns from j on that go together, of a panel with the inverse of L on the diagonal.
__attribute__((target("avx2,fma,f16c"))) inline void round_columns(const Supernode& s, int j,
                                                                   const float* panel,
                                                                   const StripPlace& to) {
  auto [strip, head] = to;
  const int rows = s.rows(), columns = strip_columns(s, j);
  const float* column = panel + static_cast<std::ptrdiff_t>(j) * rows;
  for (int c = 0; c < columns; ++c, head += kStripColumns) {
    const float* own = column + static_cast<std::ptrdiff_t>(c) * rows + j + c;
    std::fill_n(head, kStripColumns, 0.0F);
    head[0] = *own * *own;
    for (int d = 1; c + d < columns; ++d) head[d] = own[d] * *own;
  }
  for (int i = j + columns; i < rows; i += kStripRows)
    for (int c = 0; c < columns; ++c, strip += kStripRows) {
      const float* of = column + static_cast<std::ptrdiff_t>(c) * rows;
      _mm_storeu_si128(reinterpret_cast<__m128i*>(strip),
                       rounded(of + i, std::min(kStripRows, rows - i), of[j + c]));
    }
}

}  // namespace

void make_room(const SymbolicFactor& factor, HalfFactor& half) {
  half.start.assign(1, 0);
  for (const Supernode& s : factor.supernodes)
    half.start.push_back(half.start.back() + strips_before(s, s.columns));
  half.strips.reserve(half.start.back());
  half.heads.reserve(kStripColumns * static_cast<std::size_t>(factor.size()));
}

void round_panel(const SymbolicFactor& factor, const Supernode& s, const float* panel,
                 HalfFactor& half) {
  constexpr std::ptrdiff_t kValuesTogether = 65'536;
  std::uint16_t* strips = half.strips.data() + *(half.start.data() + number_in(factor, s));
  float* heads = half.heads.data() + kStripColumns * static_cast<std::size_t>(s.first);
  const auto round_groups = [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    std::uint16_t* strip = strips + strips_before(s, kStripColumns * static_cast<int>(begin));
    for (std::ptrdiff_t group = begin; group < end; ++group) {
      const int j = kStripColumns * static_cast<int>(group), columns = strip_columns(s, j);
      round_columns(s, j, panel, {strip, heads + static_cast<std::ptrdiff_t>(j) * kStripColumns});
      strip += strip_values(columns, s.rows() - j - columns);
    }
  };
  in_ranges((s.columns + kStripColumns - 1) / kStripColumns,
            1 + kValuesTogether / (kStripColumns * s.rows()), round_groups);
}

#else

void make_room(const SymbolicFactor&, HalfFactor&) {}
void round_panel(const SymbolicFactor&, const Supernode&, const float*, HalfFactor&) {}

#endif

}  // namespace foldless
