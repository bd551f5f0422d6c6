// SPDX-License-Identifier: GPL-3.0-or-later
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "app/gui/dialog_focus.h"
#include "app/gui/dialog_keys.h"
#include "app/gui/file_browser.h"
#include "app/gui/widgets.h"

namespace foldless {

void FileBrowser::draw(const Look& look) {
  if (std::exchange(opens_now_, false)) ImGui::OpenPopup("##file browser");
  if (!is_open_) return;
  if (is_elsewhere_) return draw_elsewhere(look);
  if (!begin_dialog("##file browser", look, ImVec2{780, 520})) return;
  const bool had_text = !text_.empty();
  const bool is_asking = !replacing_.empty();
  ImGui::BeginDisabled(is_asking);  // until it is answered, nothing else can be done
  draw_title(look);
  draw_breadcrumbs(look);
  ImGui::PushFont(look.fonts.small);
  const float width = ImGui::GetContentRegionAvail().x;
  const float words =
      ImGui::CalcTextSize(footer_words().c_str(), nullptr, false, width).y + look.px(14);
  ImGui::PopFont();
  const float footer = ImGui::GetFrameHeightWithSpacing() + words;
  ImGui::BeginChild("places", {look.px(150), -footer}, false, ImGuiWindowFlags_NavFlattened);
  draw_places(look);
  ImGui::EndChild();
  ImGui::SameLine();
  ImGui::PushStyleColor(ImGuiCol_ChildBg, look.palette->window);
  ImGui::BeginChild("entries", {0, -footer}, true, ImGuiWindowFlags_NavFlattened);
  begin_list_rows();
  draw_entries(look);
  end_list_rows();
  ImGui::EndChild();
  ImGui::PopStyleColor();
  ImGui::EndDisabled();
  if (is_asking) {
    draw_replace_question(look);
  } else {
    draw_footer(look);
    draw_new_folder(look);
    if (is_open_) handle_keys(had_text);
  }
  end_dialog();
}

void FileBrowser::draw_title(const Look& look) {
  const ImVec2 corner = ImGui::GetCursorPos();
  if (saves()) {
    const char* words = "New folder…";
    const float width = ImGui::CalcTextSize(words).x + 2 * ImGui::GetStyle().FramePadding.x;
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - width);
    if (ImGui::Button(words)) new_folder_.ask();
    tooltip("Makes a folder here (Ctrl+Shift+N)", look);
    ImGui::SetCursorPos(corner);
  }
  title_text(request_.title.c_str(), look);
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
    // Without a gap its highlight ends where the list does.
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2{0, ImGui::GetStyle().ItemSpacing.y});
    if (ImGui::Selectable(label.c_str(), is_here)) enter(folder);
    ImGui::PopStyleVar();
    ImGui::PopID();
    tooltip(folder.string(), look);
  };
  dim_text("Places", look);
  if (const char* home = std::getenv("HOME")) place("Home", home);
  place("Whole disk", "/");
  for (const auto& [label, folder] : request_.places) place(label, folder);
}

void FileBrowser::draw_nothing(const Look& look) {
  if (!listing_.entries.empty()) return dim_text("Nothing here matches.", look);
  if (!saves()) return dim_text("Nothing here that Foldless can open.", look);
  const std::string kind = request_.extensions.empty() ? "" : request_.extensions.front() + " ";
  dim_text("No " + kind + "files here yet.", look);
}

void FileBrowser::draw_entries(const Look& look) {
  if (shown_.empty()) draw_nothing(look);
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
  const bool is_marked = row == selected_ && (is_row_chosen_ || !saves());
  const bool clicked = ImGui::Selectable(
      "##row", is_marked,
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
  // A folder opens at once; the name that is typed so far stays.
  if (entry.is_folder) return enter(listing_.folder / entry.name);
  choose_row(row);
  if (ImGui::IsMouseDoubleClicked(0)) accept_path(listing_.folder / entry.name);
}

std::string FileBrowser::footer_words() const {
  if (!replacing_.empty())
    return "“" + replacing_.filename().string() + "” is there already. Replace it?";
  if (!message_.empty()) return message_;
  return "Arrows choose, Enter takes, Backspace goes up, Esc leaves.";
}

/// As wide as the buttons beside it leave room.
void FileBrowser::draw_field() {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float words = ImGui::CalcTextSize(accept_words()).x + ImGui::CalcTextSize("Cancel").x;
  ImGui::SetNextItemWidth(-(words + 4 * style.FramePadding.x + 2 * style.ItemSpacing.x));
  if (std::exchange(wants_focus_, false)) ImGui::SetKeyboardFocusHere();
  const bool is_edited =
      ImGui::InputTextWithHint("##text", saves() ? "Name of the file" : "Type to filter, or a path",
                               &text_, ImGuiInputTextFlags_AutoSelectAll);
  if (!is_edited) return;
  message_.clear();
  is_row_chosen_ = false;
  refilter();
}

void FileBrowser::draw_footer(const Look& look) {
  draw_field();
  ImGui::SameLine();
  const bool is_accepted = main_button(accept_words(), look);
  ImGui::SameLine();
  const bool is_dismissed = ImGui::Button("Cancel");
  ImGui::PushTextWrapPos(0);
  ImGui::PushFont(look.fonts.small);
  ImGui::TextColored(message_.empty() ? look.palette->dim : look.palette->warning, "%s",
                     footer_words().c_str());
  ImGui::PopFont();
  ImGui::PopTextWrapPos();
  if (is_accepted) accept();
  if (is_dismissed) dismiss();
}

void FileBrowser::draw_replace_question(const Look& look) {
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(footer_words().c_str());
  ImGui::PopTextWrapPos();
  const bool keeps = main_button("Keep it", look);
  ImGui::SameLine();
  const bool replaces = ImGui::Button("Replace (R)");
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  dim_text("Enter or Esc keeps it, R replaces it.", look);
  answer_replace_question(replaces, keeps);
}

void FileBrowser::draw_new_folder(const Look& look) {
  if (const auto made = new_folder_.draw(listing_.folder, look)) enter(*made);
}

}  // namespace foldless
