// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/preview.h"

#include "core/files/mesh_source.h"

namespace foldless {
namespace {

std::string words_on(const ImageImport& import) {
  if (!import.image()) return "Reading the image…";
  if (import.is_busy()) return "Making the mesh…";
  if (!import.mesh() || !import.problem().empty()) return "";
  return counted(static_cast<std::size_t>(import.mesh()->mesh.shape.triangles.cols()), "triangle");
}

Preview preview_of(const ImageImport& import) {
  Preview preview{.words = words_on(import)};
  // The outline in the colour of the rest shape, which stands out from the canvas.
  preview.layers = {.boundary = false, .handles = false, .rest = true};
  if (import.mesh()) preview.pose = import.mesh()->document.pose;
  if (!import.image()) return preview;
  preview.image = import.mesh() ? import.mesh()->texture : import.image()->texture;
  if (import.mesh()) preview.parts = import.mesh()->document.parts;
  preview.image_box = preview.view_box = import.image()->box();
  return preview;
}

Preview preview_of(const Recovery& recovery) {
  if (!recovery.problem().empty()) return {};
  if (!recovery.work()) return {.words = "Reading the copy…"};
  const Document& document = recovery.work()->document;
  const bool is_mesh = document.texture.empty();  // of a drawing the picture alone is seen
  return {.words = counted(document.handles.size(), "handle"),
          .pose = document.pose,
          .image = recovery.texture_image().image(),
          .image_box = document.texture_box,
          .parts = document.parts,
          .layers = {.wireframe = is_mesh, .boundary = is_mesh}};
}

}  // namespace

std::optional<Preview> preview_of(const Editor& editor) {
  const DocumentFiles& files = editor.files();
  if (files.recovery().is_open()) return preview_of(files.recovery());
  if (files.image_import().is_open()) return preview_of(files.image_import());
  return std::nullopt;
}

}  // namespace foldless
