// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glad/gl.h>
// OSMesa's header brings in GL's own declarations, which glad.h has already taken the place of.
#include <GL/osmesa.h>

namespace foldless {

/// The functions of OSMesa that Offscreen calls, by OSMesa's names.
struct OsMesa {
  decltype(&OSMesaCreateContextAttribs) create_context_attribs;
  decltype(&OSMesaDestroyContext) destroy_context;
  decltype(&OSMesaMakeCurrent) make_current;
  decltype(&OSMesaGetProcAddress) get_proc_address;
};

/// OSMesa, loaded when it is first asked for and kept until the process ends: it brings LLVM with
/// it, which takes longer to start than a small scene takes to solve. Throws Error when it is not
/// installed. Any thread.
const OsMesa& osmesa();

}  // namespace foldless
