// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/osmesa.h"

#include <dlfcn.h>

#include <string>

#include "core/error.h"

namespace foldless {
namespace {

/// As Debian's libosmesa6 installs it; the number changes with the interface.
constexpr const char* kLibrary = "libOSMesa.so.8";

[[noreturn]] void throw_missing() {
  throw Error(std::string("pictures cannot be drawn: ") + dlerror() + "; install libosmesa6");
}

template <typename Function>
void find(void* library, const char* name, Function& function) {
  // POSIX promises that a symbol's address is a function's; C++ has no other cast for it.
  function = reinterpret_cast<Function>(dlsym(library, name));
  if (function == nullptr) throw_missing();
}

OsMesa load() {
  void* library = dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw_missing();
  OsMesa mesa{};
  find(library, "OSMesaCreateContextAttribs", mesa.create_context_attribs);
  find(library, "OSMesaDestroyContext", mesa.destroy_context);
  find(library, "OSMesaMakeCurrent", mesa.make_current);
  find(library, "OSMesaGetProcAddress", mesa.get_proc_address);
  return mesa;
}

}  // namespace

const OsMesa& osmesa() {
  static const OsMesa mesa = load();
  return mesa;
}

}  // namespace foldless
