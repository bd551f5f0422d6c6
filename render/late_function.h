// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

namespace foldless {

/// A shared library that is loaded when the first of its functions is asked for, and stays: what a
/// call of the program does not need is not there when it starts, which takes as long as a small
/// scene takes to solve.
struct LateLibrary {
  const char* file;        ///< as the loader knows it; its number changes with the interface
  const char* what_fails;  ///< without it, the beginning of a sentence
  const char* package;     ///< that of Debian
};

/// Whether the library can be loaded; it is from then on.
bool is_installed(const LateLibrary& library);

/// The address of a function of the library, or null where it has none of that name. Throws Error
/// when the library is not there.
void* look_for_function(const LateLibrary& library, const char* name);

/// The address of a function of the library. Throws Error when library or function is not there.
void* find_function(const LateLibrary& library, const char* name);

/// A function of a LateLibrary, of the type `Function`, which is called and passed on as the
/// function itself would be. Any thread.
template <typename Function>
class LateFunction {
 public:
  constexpr LateFunction(const LateLibrary& library, const char* name)
      : library_(library), name_(name) {}

  /// Throws Error when library or function is not there.
  operator Function*() const {
    Function* function = function_.load(std::memory_order_relaxed);
    if (function) return function;
    // POSIX promises that a symbol's address is a function's; C++ has no other cast for it.
    function = reinterpret_cast<Function*>(find_function(library_, name_));
    function_.store(function, std::memory_order_relaxed);
    return function;
  }

 private:
  const LateLibrary& library_;
  const char* name_;
  mutable std::atomic<Function*> function_{nullptr};
};

}  // namespace foldless
