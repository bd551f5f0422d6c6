// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

struct ImDrawData;

namespace foldless {

/// What the panels and dialogs looked like in the last frame.
class InterfacePicture {
 public:
  /// Keeps what this frame draws; returns whether it differs from the last in any vertex.
  bool follow(const ImDrawData& data);

 private:
  std::vector<std::byte> drawn_;
  std::vector<std::byte> drawing_;  ///< memory for the next frame; holds the last but one
};

}  // namespace foldless
