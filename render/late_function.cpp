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

/// Loaded once, however often it is asked for, and counted; it is never let go.
void* load(const LateLibrary& library) { return dlopen(library.file, RTLD_LAZY | RTLD_LOCAL); }

}  // namespace

bool is_installed(const LateLibrary& library) { return load(library) != nullptr; }

void* look_for_function(const LateLibrary& library, const char* name) {
  void* loaded = load(library);
  if (!loaded) throw_missing(library);
  return dlsym(loaded, name);
}

void* find_function(const LateLibrary& library, const char* name) {
  void* function = look_for_function(library, name);
  if (!function) throw_missing(library);
  return function;
}

}  // namespace foldless
