// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/file_browser.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "app/gui/dialog_keys.h"
#include "app/gui/widgets.h"

namespace foldless {

void FileBrowser::ask(FileRequest request) {
  request_ = std::move(request);
  is_open_ = opens_now_ = wants_focus_ = true;
  message_.clear();
  replacing_.clear();
  text_ = saves() ? request_.start.filename().string() : "";
  std::error_code ignored;
  const auto start = std::filesystem::absolute(request_.start, ignored);
  enter(std::filesystem::is_directory(start, ignored) ? start : start.parent_path());
}

void FileBrowser::enter(const std::filesystem::path& folder) {
  listing_ = list_directory(folder, request_.extensions);
  message_ = listing_.error;
  if (!saves()) text_.clear();
  selected_ = 0;
  refilter();
}

void FileBrowser::refilter() {
  shown_.clear();
  for (std::size_t i = 0; i < listing_.entries.size(); ++i)
    if (saves() || matches_filter(listing_.entries[i].name, text_)) shown_.push_back(i);
  selected_ = shown_.empty() ? 0 : std::min(selected_, shown_.size() - 1);
}

void FileBrowser::accept() {
  const bool is_path = text_.find('/') != std::string::npos || text_.starts_with('~');
  if (saves() || is_path) {
    if (text_.empty()) return;
    accept_path(typed_path(text_, listing_.folder));
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
  auto file = path;
  if (!file.has_extension() && !request_.extensions.empty())
    file.replace_extension(request_.extensions.front());
  if (std::filesystem::exists(file, ignored) && file != replacing_) {
    replacing_ = file;
    return;
  }
  finish(file);
}

void FileBrowser::finish(const std::filesystem::path& path) {
  is_open_ = false;
  ImGui::CloseCurrentPopup();
  if (request_.chosen) request_.chosen(path);
}

void FileBrowser::dismiss() {
  is_open_ = false;
  ImGui::CloseCurrentPopup();
  if (request_.dismissed) request_.dismissed();
}

void FileBrowser::move_selection(int by) {
  if (shown_.empty()) return;
  const int last = static_cast<int>(shown_.size()) - 1;
  selected_ = static_cast<std::size_t>(std::clamp(static_cast<int>(selected_) + by, 0, last));
  scrolls_to_selection_ = true;
  if (const auto& entry = listing_.entries[shown_[selected_]]; saves() && !entry.is_folder)
    text_ = entry.name;
}

void FileBrowser::handle_keys() {
  if (const auto row = walk_list(selected_, shown_.size(), !text_.empty()))
    move_selection(static_cast<int>(*row) - static_cast<int>(selected_));
  if (text_.empty() && takes_key(Key::backspace)) enter(listing_.folder.parent_path());
  const DialogKeys keys = dialog_keys(TextKeys::dialog);
  if (keys.takes && replacing_.empty()) {
    accept();
    wants_focus_ = is_open_;
  }
  if (!keys.leaves) return;
  if (!replacing_.empty()) {
    replacing_.clear();
    return;
  }
  dismiss();
}

void FileBrowser::draw(const Look& look) {
  if (opens_now_) ImGui::OpenPopup("##file browser");
  opens_now_ = false;
  if (!is_open_) return;
  if (!begin_dialog("##file browser", look, ImVec2{780, 520})) return;
  title_text(request_.title.c_str(), look);
  draw_breadcrumbs(look);
  const float footer = ImGui::GetFrameHeightWithSpacing() * 2 + look.px(8);
  ImGui::BeginChild("places", {look.px(150), -footer});
  draw_places(look);
  ImGui::EndChild();
  ImGui::SameLine();
  ImGui::PushStyleColor(ImGuiCol_ChildBg, look.palette->window);
  ImGui::BeginChild("entries", {0, -footer}, true);
  draw_entries(look);
  ImGui::EndChild();
  ImGui::PopStyleColor();
  draw_footer(look);
  handle_keys();
  end_dialog();
}

void FileBrowser::draw_breadcrumbs(const Look& look) {
  if (icon_button({"up", Icon::up, "Parent folder (Backspace)"}, look))
    enter(listing_.folder.parent_path());
  std::filesystem::path folder, chosen;
  for (const auto& part : listing_.folder) {
    folder /= part;
    if (part.empty()) continue;
    ImGui::SameLine(0, look.px(2));
    const float room = ImGui::GetContentRegionAvail().x;
    if (room < ImGui::CalcTextSize(part.c_str()).x + look.px(20)) ImGui::NewLine();
    ImGui::PushID(folder.c_str());
    ImGui::PushStyleColor(ImGuiCol_Button, ImVec4{0, 0, 0, 0});
    if (ImGui::Button(part.c_str())) chosen = folder;
    ImGui::PopStyleColor();
    ImGui::PopID();
  }
  if (!chosen.empty()) enter(chosen);
}

void FileBrowser::draw_places(const Look& look) {
  const auto place = [&](const std::string& label, const std::filesystem::path& folder) {
    ImGui::PushID(folder.c_str());
    const bool is_here = folder == listing_.folder;
    if (ImGui::Selectable(label.c_str(), is_here)) enter(folder);
    ImGui::PopID();
    tooltip(folder.string(), look);
  };
  dim_text("Places", look);
  if (const char* home = std::getenv("HOME")) place("Home", home);
  place("Whole disk", "/");
  for (const auto& [label, folder] : request_.places) place(label, folder);
}

void FileBrowser::draw_entries(const Look& look) {
  if (shown_.empty())
    dim_text(
        listing_.entries.empty() ? "Nothing here that Foldless can open." : "Nothing here matches.",
        look);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(shown_.size()));
  if (scrolls_to_selection_)
    clipper.ForceDisplayRangeByIndices(static_cast<int>(selected_),
                                       static_cast<int>(selected_) + 1);
  while (clipper.Step())
    for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row)
      if (static_cast<std::size_t>(row) < shown_.size())
        draw_row(static_cast<std::size_t>(row), look);
  scrolls_to_selection_ = false;
}

void FileBrowser::draw_row(std::size_t row, const Look& look) {
  const DirectoryEntry entry = listing_.entries[shown_[row]];
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::PushID(static_cast<int>(row));
  const bool clicked = ImGui::Selectable(
      "##row", row == selected_,
      ImGuiSelectableFlags_AllowDoubleClick | ImGuiSelectableFlags_DontClosePopups);
  ImGui::PopID();
  if (scrolls_to_selection_ && row == selected_) ImGui::SetScrollHereY();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float text_x = corner.x + look.px(4);
  list.AddText({text_x, corner.y},
               packed(entry.is_folder ? look.palette->accent : look.palette->text),
               (entry.is_folder ? entry.name + "/" : entry.name).c_str());
  if (!entry.is_folder) {
    const std::string size = words_for_bytes(entry.bytes);
    const float x = corner.x + width - ImGui::CalcTextSize(size.c_str()).x - look.px(4);
    list.AddText({x, corner.y}, packed(look.palette->dim), size.c_str());
  }
  if (!clicked) return;
  selected_ = row;
  if (saves() && !entry.is_folder) text_ = entry.name;
  if (ImGui::IsMouseDoubleClicked(0) || entry.is_folder) accept_path(listing_.folder / entry.name);
}

void FileBrowser::draw_footer(const Look& look) {
  if (!replacing_.empty()) {
    draw_replace_question(look);
    return;
  }
  const std::string verb = saves() ? "Save" : "Open";
  const float buttons = look.px(150);
  ImGui::SetNextItemWidth(-buttons);
  if (std::exchange(wants_focus_, false)) ImGui::SetKeyboardFocusHere();
  ImGui::InputTextWithHint("##text", saves() ? "Name of the file" : "Type to filter, or a path",
                           &text_, ImGuiInputTextFlags_AutoSelectAll);
  if (ImGui::IsItemEdited()) {
    message_.clear();
    refilter();
  }
  ImGui::SameLine();
  const bool clicked = main_button(verb.c_str(), look);
  ImGui::SameLine();
  if (ImGui::Button("Cancel")) dismiss();
  if (!message_.empty()) {
    ImGui::TextColored(look.palette->warning, "%s", message_.c_str());
  } else {
    dim_text("Arrows choose, Enter takes, Backspace goes up, Esc leaves.", look);
  }
  if (clicked) {
    accept();
    wants_focus_ = is_open_;
  }
}

void FileBrowser::draw_replace_question(const Look& look) {
  ImGui::AlignTextToFramePadding();
  const std::string question =
      "“" + replacing_.filename().string() + "” is there already. Replace it?";
  ImGui::TextUnformatted(question.c_str());
  if (main_button("Replace", look)) {
    finish(replacing_);
    return;
  }
  ImGui::SameLine();
  if (ImGui::Button("Keep it")) {
    replacing_.clear();
    wants_focus_ = true;
  }
}

}  // namespace foldless
