// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/editor/editor.h"
#include "render/view_options.h"

namespace foldless {

/// What is shown on the canvas in place of the document while a dialog offers it.
struct Preview {
  std::string words;                                ///< on how it stands
  std::shared_ptr<const Snapshot> pose = {};        ///< null: there is none yet
  std::shared_ptr<const TexturePieces> image = {};  ///< null: none, or not yet
  std::optional<TextureBox> image_box = {};         ///< where the image lies
  std::shared_ptr<const MeshParts> parts = {};      ///< of the mesh; null: none
  std::optional<TextureBox> view_box = {};          ///< what to show; absent: the mesh
  Layers layers = {};
};

/// The preview of an image that is opened or of work that can be recovered, if there is one.
std::optional<Preview> preview_of(const Editor& editor);

}  // namespace foldless
