// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glad/gl.h>
// OSMesa's header brings in GL's own declarations, which glad.h has already taken the place of.
#include <GL/osmesa.h>

#include "render/late_function.h"

namespace foldless {

/// The functions of OSMesa that Offscreen calls; within this namespace they stand before OSMesa's
/// declarations. It brings LLVM with it.
inline constexpr LateLibrary kOsMesa{"libOSMesa.so.8", "pictures cannot be drawn", "libosmesa6"};

// NOLINTBEGIN(readability-identifier-naming): the library's own names
#define FOLDLESS_LATE(name) \
  inline constinit const LateFunction<decltype(::name)> name(kOsMesa, #name)

FOLDLESS_LATE(OSMesaCreateContextAttribs);
FOLDLESS_LATE(OSMesaDestroyContext);
FOLDLESS_LATE(OSMesaGetProcAddress);
FOLDLESS_LATE(OSMesaMakeCurrent);

#undef FOLDLESS_LATE
// NOLINTEND(readability-identifier-naming)

}  // namespace foldless
