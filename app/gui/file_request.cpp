// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/file_request.h"

namespace foldless {

std::filesystem::path with_extension(const FileRequest& request, std::filesystem::path file) {
  if (!file.has_extension() && !request.extensions.empty())
    file.replace_extension(request.extensions.front());
  return file;
}

}  // namespace foldless
