// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/version.h"

#include <built_with.h>

namespace foldless {

std::string version_text() { return "foldless " FOLDLESS_VERSION "\n"; }

std::string verbose_version_text() {
  return version_text() + "built with " FOLDLESS_COMPILER " and\n" FOLDLESS_PACKAGES;
}

}  // namespace foldless
