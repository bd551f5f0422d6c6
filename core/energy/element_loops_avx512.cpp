// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/element_loops.h"

#ifdef __x86_64__

#define FOLDLESS_LOOP __attribute__((target("avx512f,avx512dq")))
#include "core/energy/element_lanes.h"
#include "core/linear/avx512.h"

namespace foldless {

const ElementLoops* avx512_element_loops(DensityKind kind) {
  return is_avx512_worth_while() ? &loops_of<8>("AVX-512", kind) : nullptr;
}

}  // namespace foldless

#else

namespace foldless {
const ElementLoops* avx512_element_loops(DensityKind) { return nullptr; }
}  // namespace foldless

#endif
