// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <zip.h>

#include "render/late_function.h"

namespace foldless {

/// libzip's functions that ZipArchive calls; within this namespace they stand before libzip's
/// declarations. It brings a library of cryptography with it.
inline constexpr LateLibrary kZip{"libzip.so.4", "archives cannot be read", "libzip4"};

// NOLINTBEGIN(readability-identifier-naming): the library's own names
#define FOLDLESS_LATE(name) inline constinit const LateFunction<decltype(::name)> name(kZip, #name)

FOLDLESS_LATE(zip_discard);
FOLDLESS_LATE(zip_error_fini);
FOLDLESS_LATE(zip_error_init);
FOLDLESS_LATE(zip_error_strerror);
FOLDLESS_LATE(zip_fclose);
FOLDLESS_LATE(zip_fopen_index);
FOLDLESS_LATE(zip_fread);
FOLDLESS_LATE(zip_name_locate);
FOLDLESS_LATE(zip_open_from_source);
FOLDLESS_LATE(zip_source_buffer_create);
FOLDLESS_LATE(zip_source_free);
FOLDLESS_LATE(zip_stat);

#undef FOLDLESS_LATE
// NOLINTEND(readability-identifier-naming)

}  // namespace foldless
