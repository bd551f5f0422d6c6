// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/element_loops.h"

#ifdef __x86_64__

#define FOLDLESS_LOOP __attribute__((target("avx512f,avx512dq")))
#include "core/energy/element_lanes.h"

namespace foldless {

// Earlier processors with AVX-512, which lack VBMI2, slow down where it is used.
const ElementLoops* avx512_element_loops(DensityKind kind) {
  const bool is_there = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                        __builtin_cpu_supports("avx512vbmi2");
  return is_there ? &loops_of<8>("AVX-512", kind) : nullptr;
}

}  // namespace foldless

#else

namespace foldless {
const ElementLoops* avx512_element_loops(DensityKind) { return nullptr; }
}  // namespace foldless

#endif
