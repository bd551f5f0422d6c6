// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/gui/look.h"

namespace foldless {

/// Asks for the name of a new folder, over the dialog that saves a file.
class NewFolder {
 public:
  void ask();
  /// Inside the dialog below. Returns the folder when it was made in this frame.
  std::optional<std::filesystem::path> draw(const std::filesystem::path& parent, const Look& look);

 private:
  std::string name_;
  std::string problem_;  ///< why the last name was refused
  bool opens_now_ = false;
  bool wants_focus_ = false;
};

}  // namespace foldless
