// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <filesystem>
#include <new>
#include <string>

namespace foldless {

/// What the user is told of an exception: its message, or words in place of the bare
/// `std::bad_alloc`. Throws nothing itself, so that a thread can say why it could not go on.
inline std::string words_of_exception(const std::exception& failure) noexcept {
  try {
    if (dynamic_cast<const std::bad_alloc*>(&failure)) return "there is not enough memory";
    return failure.what();
  } catch (...) {
    return "out of memory";  // short enough to need none
  }
}

/// The same of what was done with a file, which other messages name themselves.
inline std::string words_of_exception(const std::exception& failure,
                                      const std::filesystem::path& file) noexcept {
  try {
    if (dynamic_cast<const std::bad_alloc*>(&failure))
      return std::string(file).append(": ").append(words_of_exception(failure));
  } catch (...) {
    return "out of memory";
  }
  return words_of_exception(failure);
}

}  // namespace foldless
