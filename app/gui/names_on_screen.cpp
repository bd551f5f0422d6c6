// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/names_on_screen.h"

namespace foldless {
namespace {

void need_recovery(Glyphs& glyphs, const Recovery& recovery) {
  for (std::size_t i = 0; i < recovery.count(); ++i) {
    glyphs.need(recovery.origin(i).name);
    glyphs.need(recovery.origin(i).path.native());
  }
  if (!recovery.is_open()) return;
  glyphs.need(recovery.problem());
  glyphs.need(recovery.unread());
}

void need_browser(Glyphs& glyphs, const FileBrowser& browser) {
  if (!browser.is_open()) return;
  const DirectoryListing& listing = browser.listing();
  glyphs.need(listing.folder.native());
  glyphs.need(listing.error);
  for (const DirectoryEntry& entry : listing.entries) glyphs.need(entry.name);
}

}  // namespace

void need_names(Glyphs& glyphs, const Editor& editor, const UiState& state) {
  const Document& document = editor.document();
  glyphs.need(document.name);
  glyphs.need(document.description);
  glyphs.need(document.texture.native());
  glyphs.need(editor.files().path().native());
  for (const auto& path : editor.files().recent()) glyphs.need(path.native());
  for (const Handle& handle : document.handles) glyphs.need(handle.name);
  for (const Toast& toast : editor.messages().toasts()) glyphs.need(toast.text);
  need_recovery(glyphs, editor.files().recovery());
  need_browser(glyphs, state.browser);
}

}  // namespace foldless
