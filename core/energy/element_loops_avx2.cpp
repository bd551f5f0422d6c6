// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/element_loops.h"

#ifdef __x86_64__

#define FOLDLESS_LOOP __attribute__((target("avx2")))
#include "core/energy/element_lanes.h"

namespace foldless {

const ElementLoops* avx2_element_loops(DensityKind kind) {
  return __builtin_cpu_supports("avx2") ? &loops_of<4>("AVX2", kind) : nullptr;
}

}  // namespace foldless

#else

namespace foldless {
const ElementLoops* avx2_element_loops(DensityKind) { return nullptr; }
}  // namespace foldless

#endif
