// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <liblzf/lzf.h>

#include "render/late_function.h"

namespace foldless {

/// The compression of Krita's tiles.
inline constexpr LateLibrary kLzf{"liblzf.so.1", "Krita files cannot be read", "liblzf1"};

// NOLINTNEXTLINE(readability-identifier-naming): the library's own name
inline constinit const LateFunction<decltype(::lzf_decompress)> lzf_decompress(kLzf,
                                                                               "lzf_decompress");

}  // namespace foldless
