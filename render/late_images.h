// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <png.h>
#include <turbojpeg.h>
#include <webp/decode.h>

#include "render/late_function.h"

namespace foldless {

/// Functions that read and write images; within this namespace they stand before the libraries'
/// own declarations.
inline constexpr LateLibrary kPng{"libpng16.so.16", "PNG images can be neither read nor written",
                                  "libpng16-16"};

inline constexpr LateLibrary kTurboJpeg{"libturbojpeg.so.0", "JPEG images cannot be read",
                                        "libturbojpeg0"};

inline constexpr LateLibrary kWebp{"libwebp.so.7", "WebP images cannot be read", "libwebp7"};

// NOLINTBEGIN(readability-identifier-naming): the library's own names
#define FOLDLESS_LATE(library, name) \
  inline constinit const LateFunction<decltype(::name)> name(library, #name)

FOLDLESS_LATE(kPng, png_image_begin_read_from_memory);
FOLDLESS_LATE(kPng, png_image_finish_read);
FOLDLESS_LATE(kPng, png_image_free);
FOLDLESS_LATE(kPng, png_image_write_to_memory);

FOLDLESS_LATE(kTurboJpeg, tjDecompress2);
FOLDLESS_LATE(kTurboJpeg, tjDecompressHeader3);
FOLDLESS_LATE(kTurboJpeg, tjDestroy);
FOLDLESS_LATE(kTurboJpeg, tjGetErrorStr2);
FOLDLESS_LATE(kTurboJpeg, tjInitDecompress);

FOLDLESS_LATE(kWebp, WebPDecodeRGBAInto);
FOLDLESS_LATE(kWebp, WebPGetInfo);

#undef FOLDLESS_LATE
// NOLINTEND(readability-identifier-naming)

}  // namespace foldless
