// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/gui/directory.h"
#include "app/gui/file_request.h"
#include "app/gui/look.h"
#include "app/gui/new_folder.h"
#include "app/gui/portal.h"

namespace foldless {

/// Asks for a file: in the desktop's dialog where there is one, else in one of our own, as many
/// Linux desktops have none. In ours typing filters the list; a typed path goes there; arrows,
/// Enter, Backspace and Esc work without the mouse.
class FileBrowser {
 public:
  /// Once a frame: the way to the desktop's dialog, which is used from now on where it is there;
  /// null: ours is. True where it has just ended.
  bool follow(Portal* portal);
  /// The desktop will say something: follow() has to be called again soon.
  bool awaits_portal() const { return portal_ && portal_->is_waiting(); }
  void ask(FileRequest request);
  /// Asks the last request again, with the name as it was: the file could not be written. Says why.
  void ask_again(const std::string& problem);
  bool is_open() const { return is_open_; }
  /// How often ask() was called.
  std::size_t asked() const { return asked_; }
  /// The folder that it shows, or showed last.
  const DirectoryListing& listing() const { return listing_; }
  void draw(const Look& look);

 private:
  void show();
  void take_answer(const PortalAnswer& answer);
  void draw_elsewhere(const Look& look);
  void enter(const std::filesystem::path& folder);
  void accept();
  void accept_path(const std::filesystem::path& path);
  void finish(const std::filesystem::path& path);
  void dismiss();
  void refilter();
  void choose_row(std::size_t row);
  /// The folder whose row was chosen last, when saving; null: the typed name counts.
  const DirectoryEntry* chosen_folder() const;
  void handle_keys(bool had_text);
  void answer_replace_question(bool replaces, bool keeps);
  void draw_title(const Look& look);
  void draw_breadcrumbs(const Look& look);
  void draw_places(const Look& look);
  void draw_entries(const Look& look);
  void draw_row(std::size_t row, const Look& look);
  void draw_nothing(const Look& look);
  void draw_field();
  void draw_footer(const Look& look);
  void draw_replace_question(const Look& look);
  void draw_new_folder(const Look& look);
  std::string footer_words() const;

  const char* accept_words() const { return saves() ? "Save" : "Open"; }
  bool saves() const { return request_.purpose == FileRequest::Purpose::save; }

  FileRequest request_;
  std::size_t asked_ = 0;
  DirectoryListing listing_;
  std::vector<std::size_t> shown_;   ///< indices of the entries that pass the filter
  std::size_t selected_ = 0;         ///< index into shown_
  bool is_row_chosen_ = false;       ///< by arrows or the mouse, after the text was typed
  std::string text_;                 ///< filter, path or name of the file to save
  std::string message_;              ///< why the last choice was refused
  std::filesystem::path replacing_;  ///< existing file that waits for a yes
  NewFolder new_folder_;
  Portal* portal_ = nullptr;
  std::optional<PortalAnswer> answer_;  ///< of the desktop's dialog, not yet dealt with
  bool is_elsewhere_ = false;           ///< the desktop's dialog is open
  bool is_open_ = false;
  bool opens_now_ = false;
  bool wants_focus_ = false;
  bool scrolls_to_selection_ = false;
};

}  // namespace foldless
