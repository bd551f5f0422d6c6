// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <webp/encode.h>
#include <webp/mux.h>

#include "render/late_function.h"

namespace foldless {

/// The functions that make an animated WebP; within this namespace they stand before the
/// libraries' own declarations. Of those that check a version the headers have the outer half.
inline constexpr LateLibrary kWebpEncoder{"libwebp.so.7", "animated WebP cannot be made",
                                          "libwebp7"};

inline constexpr LateLibrary kWebpMux{"libwebpmux.so.3", "animated WebP cannot be made",
                                      "libwebpmux3"};

// NOLINTBEGIN(readability-identifier-naming): the library's own names
#define FOLDLESS_LATE(library, name) \
  inline constinit const LateFunction<decltype(::name)> name(library, #name)

FOLDLESS_LATE(kWebpEncoder, WebPConfigInitInternal);
FOLDLESS_LATE(kWebpEncoder, WebPFree);
FOLDLESS_LATE(kWebpEncoder, WebPPictureFree);
FOLDLESS_LATE(kWebpEncoder, WebPPictureImportRGBA);
FOLDLESS_LATE(kWebpEncoder, WebPPictureInitInternal);

FOLDLESS_LATE(kWebpMux, WebPAnimEncoderAdd);
FOLDLESS_LATE(kWebpMux, WebPAnimEncoderAssemble);
FOLDLESS_LATE(kWebpMux, WebPAnimEncoderDelete);
FOLDLESS_LATE(kWebpMux, WebPAnimEncoderGetError);
FOLDLESS_LATE(kWebpMux, WebPAnimEncoderNewInternal);
FOLDLESS_LATE(kWebpMux, WebPAnimEncoderOptionsInitInternal);

#undef FOLDLESS_LATE
// NOLINTEND(readability-identifier-naming)

}  // namespace foldless
