// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "app/editor/editor.h"
#include "app/gui/animation_export.h"
#include "app/gui/canvas_picture.h"
#include "render/scene_renderer.h"

namespace foldless {

class FileBrowser;

struct BackgroundExports;

/// What the user chose to export: a picture, a figure, or the mesh.
struct ExportJob {
  std::filesystem::path path;                     ///< its extension says which format
  PictureOptions picture;                         ///< of pictures, figures and sequences
  bool is_sequence = false;                       ///< the path is that of a new folder for pictures
  std::optional<AnimationChoice> animation = {};  ///< of an animation; the rest counts not then
  bool is_chosen_now = false;  ///< in the file browser, which asks again when writing fails

  bool is_picture() const { return path.extension() == ".png"; }
};

/// What an export is made with.
struct ExportMeans {
  SceneRenderer& renderer;
  BackgroundExports& exports;
  FileBrowser& browser;
};

/// Begins to write what a job asks for, by `exports`, which say when it is done. Where that fails,
/// the file browser asks again if it was there that the file was chosen.
void carry_out(const ExportJob& job, Editor& editor, const ExportMeans& means);

}  // namespace foldless
