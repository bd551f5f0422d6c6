// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <system_error>

#include "app/editor/document_files.h"

namespace foldless {

void DocumentFiles::take_image() {
  takes_image_ = import_.is_open();
  update_import();
}

void DocumentFiles::close_import() {
  takes_image_ = false;
  if (!import_.is_open()) return;
  import_.close();
  messages_.redraw();
}

void DocumentFiles::update_import() {
  if (import_.poll()) messages_.redraw();
  if (!import_.problem().empty()) takes_image_ = false;
  if (import_.is_open() && !import_.image() && !import_.is_busy()) {
    messages_.toast(ToastKind::error, import_.problem());
    std::error_code error;
    if (!std::filesystem::exists(import_.file(), error)) recent_.remove(import_.file());
    return close_import();
  }
  if (!takes_image_ || !import_.is_ready()) return;
  const auto image = import_.image();
  const std::shared_ptr<const ImportedMesh> mesh = import_.mesh();
  const Document& document = mesh->document;
  texture_image_.adopt(image->file, document.parts, mesh->texture, image->stamp);
  install(document, "Open " + image->file.filename().string());
  view_.options().layers = {.wireframe = false, .boundary = false};  // the picture alone
  recent_.add(image->file);
}

void DocumentFiles::reload_texture() { texture_image_.refresh(true); }

void DocumentFiles::follow_texture() {
  constexpr double kBetweenLooks = 1;  // seconds
  texture_image_.follow(draft_.document().texture, draft_.document().parts);
  // There is a frame when the window gets the focus back, from the program that painted.
  if (messages_.now() - looked_at_texture_ >= kBetweenLooks) {
    looked_at_texture_ = messages_.now();
    texture_image_.refresh();
  }
  if (!texture_image_.poll()) return;
  messages_.redraw();
  if (texture_image_.is_refreshed() && texture_image_.problem().empty())
    messages_.toast(ToastKind::notice,
                    "Read " + draft_.document().texture.filename().string() + " again");
  for (const std::string& notice : texture_image_.notices())
    messages_.toast(ToastKind::notice, notice);
  if (!texture_image_.problem().empty())
    messages_.toast(ToastKind::error, texture_image_.problem());
}

}  // namespace foldless
