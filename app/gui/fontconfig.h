// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fontconfig/fontconfig.h>

#include "render/late_function.h"

namespace foldless {

/// fontconfig's functions that fallback_fonts calls; within this namespace they stand before
/// fontconfig's declarations.
inline constexpr LateLibrary kFontconfig{"libfontconfig.so.1", "fonts cannot be looked for",
                                         "libfontconfig1"};

// NOLINTBEGIN(readability-identifier-naming): the library's own names
#define FOLDLESS_LATE(name) \
  inline constinit const LateFunction<decltype(::name)> name(kFontconfig, #name)

FOLDLESS_LATE(FcCharSetAddChar);
FOLDLESS_LATE(FcCharSetCreate);
FOLDLESS_LATE(FcCharSetDestroy);
FOLDLESS_LATE(FcCharSetHasChar);
FOLDLESS_LATE(FcConfigDestroy);
FOLDLESS_LATE(FcConfigSubstitute);
FOLDLESS_LATE(FcDefaultSubstitute);
FOLDLESS_LATE(FcFontMatch);
FOLDLESS_LATE(FcFreeTypeQuery);
FOLDLESS_LATE(FcInitLoadConfigAndFonts);
FOLDLESS_LATE(FcPatternAddBool);
FOLDLESS_LATE(FcPatternAddCharSet);
FOLDLESS_LATE(FcPatternCreate);
FOLDLESS_LATE(FcPatternDestroy);
FOLDLESS_LATE(FcPatternGetBool);
FOLDLESS_LATE(FcPatternGetCharSet);
FOLDLESS_LATE(FcPatternGetInteger);
FOLDLESS_LATE(FcPatternGetString);

#undef FOLDLESS_LATE
// NOLINTEND(readability-identifier-naming)

}  // namespace foldless
