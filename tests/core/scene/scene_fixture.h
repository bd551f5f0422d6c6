// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/scene/scene_io.h"
#include "tests/support/errors.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {

inline constexpr std::array<std::string_view, 2> kMethodNames{"paper-flip", "paper-noflip"};

/// Two triangles over the unit square and a vertex that belongs to no triangle.
inline constexpr std::string_view kSquareObj =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 9 9 0\nf 1 2 3\nf 1 3 4\n";

/// A folder with square.obj, in which scenes are tried.
class SceneFolder {
 public:
  SceneFolder() { folder_.write("square.obj", kSquareObj); }

  std::filesystem::path operator/(std::string_view name) const { return folder_ / name; }
  const TemporaryFolder& folder() const { return folder_; }

  LoadedScene load(std::string_view text) const {
    return load_scene(folder_.write("scene.json", text), kMethodNames);
  }
  /// The error without the folder, `scene.json:1: ...`.
  std::string error_in(std::string_view text) const {
    std::string error = error_of([&] { load(text); });
    const std::string prefix = folder_.path().string() + '/';
    for (auto at = error.find(prefix); at != error.npos; at = error.find(prefix))
      error.erase(at, prefix.size());
    return error;
  }
  /// The error of a plain scene with more keys before its end.
  std::string error_with(std::string_view more) const {
    return error_in(R"({"mesh": "square.obj", "energy": "arap",)"
                    "\n" +
                    std::string(more) + "}");
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace foldless::test
