// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/gui/directory.h"
#include "app/gui/look.h"
#include "app/gui/new_folder.h"

namespace foldless {

/// A folder one click away.
struct Place {
  std::string label;
  std::filesystem::path folder;
};

/// What the file browser is asked for.
struct FileRequest {
  enum class Purpose { open, save };
  Purpose purpose = Purpose::open;
  std::string title;
  std::vector<std::string> extensions;  ///< `.json`; the first is added to a name that has none
  std::filesystem::path start;          ///< folder, or suggested file
  std::vector<Place> places;            ///< beside home
  std::function<void(const std::filesystem::path&)> chosen;
  std::function<void()> dismissed;  ///< may be empty
};

/// An own dialog for choosing a file: many Linux desktops have none. Typing filters the list; a
/// typed path goes there; arrows, Enter, Backspace and Esc work without the mouse.
class FileBrowser {
 public:
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
  void draw_field(const Look& look);
  void draw_footer(const Look& look);
  void draw_replace_question(const Look& look);
  void draw_new_folder(const Look& look);
  std::string footer_words() const;

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
  bool is_open_ = false;
  bool opens_now_ = false;
  bool wants_focus_ = false;
  bool scrolls_to_selection_ = false;
};

}  // namespace foldless
