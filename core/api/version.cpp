// SPDX-License-Identifier: GPL-3.0-or-later
#include <foldless/version.h>

namespace foldless {

const char* library_version() { return FOLDLESS_VERSION; }

}  // namespace foldless
