// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/embedding.h"

#include <cmath>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "core/error.h"
#include "core/files/atomic_file.h"
#include "core/files/mesh_io.h"
#include "core/files/mesh_readers.h"
#include "core/files/text_lines.h"

namespace foldless {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHandlesFile = "handles.txt";

/// Adds handles at the vertices that a file names.
class EmbeddingHandles {
 public:
  EmbeddingHandles(const fs::path& file, Scene& scene, const Points& images)
      : name_(file.string()),
        scene_(scene),
        images_(images),
        is_used_(static_cast<std::size_t>(scene.rest.cols()), false),
        is_named_(is_used_) {
    for (const int v : scene.triangles.reshaped()) is_used_[static_cast<std::size_t>(v)] = true;
  }

  void read(std::string_view text) {
    for (TextLines lines(text); lines.next();) {
      line_ = lines.number();
      Words words(without_comment(lines.line()));
      for (std::string_view word = words.next(); !word.empty(); word = words.next()) add(word);
    }
    if (scene_.handles.empty()) throw Error(name_ + ": names no vertex");
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw Error(name_ + ":" + std::to_string(line_) + ": " + what);
  }

  void add(std::string_view word) {
    const auto number = parse_integer(word);
    const auto v = static_cast<std::size_t>(number.value_or(-1));
    if (!number || v >= is_used_.size())
      refuse(in_quotes(word) + " is no vertex; they are 0 to " +
             std::to_string(is_used_.size() - 1));
    if (!is_used_[v]) refuse(in_quotes(word) + " is a vertex that belongs to no triangle");
    if (is_named_[v]) refuse(in_quotes(word) + " is named twice");
    const Vec2 target = images_.col(*number);
    if (!std::isfinite(target.x()) || !std::isfinite(target.y()))
      refuse(in_quotes(word) +
             " is a vertex without texture coordinates (vt), which say where it goes");
    is_named_[v] = true;
    const bool stays = target == scene_.rest.col(*number);
    scene_.handles.push_back({static_cast<int>(scene_.handles.size()), *number, target,
                              stays ? HandleKind::pin : HandleKind::drag});
  }

  std::string name_;
  Scene& scene_;
  const Points& images_;
  std::vector<bool> is_used_;   ///< by vertex: by a triangle
  std::vector<bool> is_named_;  ///< by vertex
  int line_ = 0;
};

}  // namespace

bool is_embedding(const fs::path& file) {
  std::error_code none;
  return file.extension() == ".obj" && fs::is_regular_file(file.parent_path() / kHandlesFile, none);
}

LoadedScene scene_from_embedding(const fs::path& file) {
  LoadedScene loaded = scene_from_mesh(file);
  const Points images = read_obj_texture(read_file(file), file.string());
  const fs::path handles = file.parent_path() / kHandlesFile;
  EmbeddingHandles(handles, loaded.scene, images).read(read_file(handles));
  return loaded;
}

}  // namespace foldless
