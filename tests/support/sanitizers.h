// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace foldless::test {

/// Whether this is built with the address or the thread sanitizer, which take memory and time of
/// their own.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSanitized = true;
#elif defined(__has_feature)
constexpr bool kIsSanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
constexpr bool kIsSanitized = false;
#endif

/// Of so many seeds those that are tried: under a sanitizer, which watches the same code run
/// several times as slowly, a quarter.
constexpr std::uint64_t seeds(std::uint64_t count) {
  return kIsSanitized ? (count + 3) / 4 : count;
}

}  // namespace foldless::test
