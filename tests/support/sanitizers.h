// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

}  // namespace foldless::test
