// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/dense_kernels.h"

#ifdef __aarch64__

#include <arm_neon.h>

#include "core/linear/dense_tile.h"

namespace foldless {
namespace {

struct TwoRows {
  using Value = double;
  static constexpr int kRows = 2;
  float64x2_t v;
  static TwoRows zero() { return {vdupq_n_f64(0)}; }
  static TwoRows load(const double* p, AllRows) { return {vld1q_f64(p)}; }
  static TwoRows all(const double* p) { return {vld1q_dup_f64(p)}; }
  void store(double* p, AllRows) const { vst1q_f64(p, v); }
  void subtract(TwoRows a, TwoRows b) { v = vfmsq_f64(v, a.v, b.v); }
  void multiply(TwoRows a) { v = vmulq_f64(a.v, v); }
};

template <int Columns, StripKind Kind>
void do_strip(const StripAndTriangle<double>& t) {
  const int rows = t.strip.rows;
  int i = 0;
  for (; i + 8 <= rows; i += 8) do_tile<TwoRows, 4, Columns, Kind>(t, i, AllRows{});
  if (i + 4 <= rows) {
    do_tile<TwoRows, 2, Columns, Kind>(t, i, AllRows{});
    i += 4;
  }
  if (i < rows) do_tile<TwoRows, 1, Columns, Kind>(t, i, AllRows{});
}

template <StripKind Kind>
void do_strip(const StripAndTriangle<double>& t) {
  if (t.strip.columns == 4)
    do_strip<4, Kind>(t);
  else
    do_strip<2, Kind>(t);
}

void neon_subtract(const ColumnStrip<double>& s) { do_strip<StripKind::subtract>({s, nullptr}); }
void neon_set_negative(const ColumnStrip<double>& s) {
  do_strip<StripKind::set_negative>({s, nullptr});
}
void neon_subtract_and_solve(const ColumnStrip<double>& s, const double* triangle) {
  do_strip<StripKind::solve>({s, triangle});
}

const DenseKernels<double> kernels_for_neon = {"NEON", neon_subtract, neon_set_negative,
                                               neon_subtract_and_solve};

}  // namespace

template <>
const DenseKernels<double>* neon_kernels() {
  return &kernels_for_neon;
}

}  // namespace foldless

#else

namespace foldless {
template <>
const DenseKernels<double>* neon_kernels() {
  return nullptr;
}
}  // namespace foldless

#endif

namespace foldless {
template <>
const DenseKernels<float>* neon_kernels() {
  return nullptr;
}
}  // namespace foldless
