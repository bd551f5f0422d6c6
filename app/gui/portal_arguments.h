// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/gui/file_request.h"
#include "app/gui/gio.h"

namespace foldless {

/// Who asks a portal, and what they call what they ask.
struct PortalCaller {
  std::string parent_window;
  std::string token;
};

/// The arguments of OpenFile and SaveFile, (ssa{sv}), floating as all of GLib's new variants:
/// whoever calls with them owns them.
GVariant* portal_arguments(const FileRequest& request, const PortalCaller& caller);

}  // namespace foldless
