// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/file_browser.h"

#include <imgui_internal.h>

#include <algorithm>
#include <utility>

#include "app/gui/dialog_keys.h"

namespace foldless {

void FileBrowser::ask(FileRequest request) {
  request_ = std::move(request);
  ++asked_;
  is_open_ = true;
  is_elsewhere_ = portal_ && portal_->is_there();
  answer_.reset();
  if (is_elsewhere_)
    portal_->ask(request_);
  else
    show();
}

void FileBrowser::show() {
  is_elsewhere_ = false;
  opens_now_ = true;
  text_ = saves() ? request_.start.filename().string() : "";
  std::error_code ignored;
  const auto start = std::filesystem::absolute(request_.start, ignored);
  enter(std::filesystem::is_directory(start, ignored) ? start : start.parent_path());
}

void FileBrowser::ask_again(const std::string& problem) {
  is_elsewhere_ = false;
  is_open_ = opens_now_ = wants_focus_ = true;
  replacing_.clear();
  message_ = problem;
}

void FileBrowser::enter(const std::filesystem::path& folder) {
  listing_ = list_directory(folder, request_.extensions);
  message_ = listing_.error;
  replacing_.clear();
  if (!saves()) text_.clear();
  selected_ = 0;
  is_row_chosen_ = false;
  wants_focus_ = true;
  refilter();
}

void FileBrowser::refilter() {
  shown_.clear();
  for (std::size_t i = 0; i < listing_.entries.size(); ++i)
    if (saves() || matches_filter(listing_.entries[i].name, text_)) shown_.push_back(i);
  selected_ = shown_.empty() ? 0 : std::min(selected_, shown_.size() - 1);
}

const DirectoryEntry* FileBrowser::chosen_folder() const {
  if (!saves() || !is_row_chosen_ || selected_ >= shown_.size()) return nullptr;
  const DirectoryEntry& entry = listing_.entries[shown_[selected_]];
  return entry.is_folder ? &entry : nullptr;
}

void FileBrowser::accept() {
  const bool is_path = text_.find('/') != std::string::npos || text_.starts_with('~');
  wants_focus_ = true;
  if (const DirectoryEntry* folder = chosen_folder()) {
    enter(listing_.folder / folder->name);
  } else if (saves() || is_path) {
    if (!text_.empty()) accept_path(typed_path(text_, listing_.folder));
  } else if (selected_ < shown_.size()) {
    accept_path(listing_.folder / listing_.entries[shown_[selected_]].name);
  } else {
    message_ = "No file here matches “" + text_ + "”.";
  }
}

void FileBrowser::accept_path(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    if (saves()) text_.clear();
    enter(path);
    return;
  }
  if (!saves()) {
    if (std::filesystem::exists(path, ignored)) return finish(path);
    message_ = "There is no file “" + path.string() + "”.";
    return;
  }
  const auto file = with_extension(request_, path);
  if (std::filesystem::exists(file, ignored))
    replacing_ = file;
  else
    finish(file);
}

void FileBrowser::finish(const std::filesystem::path& path) {
  is_open_ = is_elsewhere_ = false;
  ImGui::CloseCurrentPopup();
  if (request_.chosen) request_.chosen(path);
}

void FileBrowser::dismiss() {
  is_open_ = is_elsewhere_ = false;
  ImGui::CloseCurrentPopup();
  if (request_.dismissed) request_.dismissed();
}

void FileBrowser::choose_row(std::size_t row) {
  selected_ = row;
  is_row_chosen_ = wants_focus_ = true;
  message_.clear();
  const DirectoryEntry& entry = listing_.entries[shown_[row]];
  if (!saves() || entry.is_folder) return;
  // A field that is being edited would put its own text back.
  ImGui::ClearActiveID();
  text_ = entry.name;
}

/// In the save dialog the first arrow key chooses the first row: none was chosen before.
void FileBrowser::handle_keys(bool had_text) {
  const auto walked = walk_list(selected_, shown_.size(), had_text);
  if (walked) {
    choose_row(saves() && !is_row_chosen_ ? 0 : *walked);
    scrolls_to_selection_ = true;
  }
  if (!had_text && takes_key(Key::backspace)) enter(listing_.folder.parent_path());
  const ImGuiIO& io = ImGui::GetIO();
  if (saves() && io.KeyCtrl && io.KeyShift && takes_key(Key::n)) new_folder_.ask();
  const DialogKeys keys = dialog_keys(TextKeys::dialog);
  if (keys.leaves) return dismiss();
  if (keys.takes) accept();
}

/// Nothing brings a replaced file back: only a key of its own replaces it.
void FileBrowser::answer_replace_question(bool replaces, bool keeps) {
  const DialogKeys keys = dialog_keys();
  if (replaces || takes_key(Key::r)) {
    finish(std::exchange(replacing_, {}));
  } else if (keeps || keys.takes || keys.leaves) {
    replacing_.clear();
    wants_focus_ = true;
  }
}

}  // namespace foldless
