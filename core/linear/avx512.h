// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace foldless {

#ifdef __x86_64__
/// Whether the processor has AVX-512 (F and DQ) and is the faster for it: the first generation with
/// it lowers its clock where it is used; the later ones have VBMI2 too.
inline bool is_avx512_worth_while() {
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
         __builtin_cpu_supports("avx512vbmi2");
}
#endif

}  // namespace foldless
