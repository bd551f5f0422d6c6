// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <imgui.h>

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <vector>

#include "app/editor/file_sketch.h"
#include "core/run/latest_job.h"
#include "render/gl_objects.h"
#include "render/scene_renderer.h"

namespace foldless {

/// Small pictures of files: read one after the other on a thread of their own, drawn one a frame.
/// A file that changed gets a new one. Every function needs the GL context of the constructor.
class Thumbnails {
 public:
  /// Pixels of all of them from now on, and their colours; other ones are made anew.
  void set_look(int width, int height, Theme theme);
  /// The picture of a file; null while it is made, and where it cannot be. Asking orders it.
  ImTextureID of(const std::filesystem::path& file);
  /// Draws the one that was read last and begins to read the next. Returns whether there are
  /// any that wait.
  bool update();

 private:
  struct Entry {
    std::filesystem::file_time_type changed;
    std::optional<Texture> texture;  ///< absent: it cannot be read
  };
  struct Read {
    std::filesystem::path file;
    FileSketch sketch;
  };

  void begin_next();
  Texture draw(const FileSketch& sketch);

  int width_ = 0, height_ = 0;
  Theme theme_ = Theme::dark;
  std::optional<SceneRenderer> renderer_;  ///< made for the first
  std::map<std::filesystem::path, Entry> made_;
  std::vector<std::filesystem::path> wanted_;
  std::optional<std::filesystem::path> reading_;
  std::mutex mutex_;  ///< of what follows
  std::optional<Read> read_;
  LatestJob job_;  ///< the last member: it ends before what it uses
};

}  // namespace foldless
