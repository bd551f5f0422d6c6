// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gif_lib.h>

#include "render/late_function.h"

namespace foldless {

/// The functions of giflib that are called; within this namespace they stand before its own
/// declarations.
inline constexpr LateLibrary kGif{"libgif.so.7", "GIF images can be neither read nor written",
                                  "libgif7"};

// NOLINTBEGIN(readability-identifier-naming): the library's own names
#define FOLDLESS_LATE(library, name) \
  inline constinit const LateFunction<decltype(::name)> name(library, #name)

FOLDLESS_LATE(kGif, DGifCloseFile);
FOLDLESS_LATE(kGif, DGifExtensionToGCB);
FOLDLESS_LATE(kGif, DGifGetExtension);
FOLDLESS_LATE(kGif, DGifGetExtensionNext);
FOLDLESS_LATE(kGif, DGifGetImageDesc);
FOLDLESS_LATE(kGif, DGifGetLine);
FOLDLESS_LATE(kGif, DGifGetRecordType);
FOLDLESS_LATE(kGif, DGifOpen);
FOLDLESS_LATE(kGif, EGifCloseFile);
FOLDLESS_LATE(kGif, EGifGCBToExtension);
FOLDLESS_LATE(kGif, EGifOpen);
FOLDLESS_LATE(kGif, EGifPutExtension);
FOLDLESS_LATE(kGif, EGifPutExtensionBlock);
FOLDLESS_LATE(kGif, EGifPutExtensionLeader);
FOLDLESS_LATE(kGif, EGifPutExtensionTrailer);
FOLDLESS_LATE(kGif, EGifPutImageDesc);
FOLDLESS_LATE(kGif, EGifPutLine);
FOLDLESS_LATE(kGif, EGifPutScreenDesc);
FOLDLESS_LATE(kGif, EGifSetGifVersion);
FOLDLESS_LATE(kGif, GifErrorString);
FOLDLESS_LATE(kGif, GifFreeMapObject);
FOLDLESS_LATE(kGif, GifMakeMapObject);

#undef FOLDLESS_LATE
// NOLINTEND(readability-identifier-naming)

}  // namespace foldless
