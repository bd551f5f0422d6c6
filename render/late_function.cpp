// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/late_function.h"

#include <dlfcn.h>

#include <string>

#include "core/error.h"

namespace foldless {
namespace {

[[noreturn]] void throw_missing(const LateLibrary& library) {
  throw Error(std::string(library.what_fails) + ": " + dlerror() + "; install " + library.package);
}

}  // namespace

void* find_function(const LateLibrary& library, const char* name) {
  // Loaded once, however often it is asked for, and counted; it is never let go.
  void* loaded = dlopen(library.file, RTLD_LAZY | RTLD_LOCAL);
  if (!loaded) throw_missing(library);
  void* function = dlsym(loaded, name);
  if (!function) throw_missing(library);
  return function;
}

}  // namespace foldless
