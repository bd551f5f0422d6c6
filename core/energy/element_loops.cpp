// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/element_loops.h"

namespace foldless {

const ElementLoops& element_loops(DensityKind kind) {
  if (const ElementLoops* avx512 = avx512_element_loops(kind)) return *avx512;
  const ElementLoops* avx2 = avx2_element_loops(kind);
  return avx2 ? *avx2 : plain_element_loops(kind);
}

}  // namespace foldless
