// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/new_folder.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <utility>

#include "app/gui/dialog_keys.h"
#include "app/gui/directory.h"
#include "app/gui/short_text.h"
#include "app/gui/widgets.h"

namespace foldless {

void NewFolder::ask() {
  name_.clear();
  problem_.clear();
  opens_now_ = wants_focus_ = true;
}

std::optional<std::filesystem::path> NewFolder::draw(const std::filesystem::path& parent,
                                                     const Look& look) {
  if (std::exchange(opens_now_, false)) ImGui::OpenPopup("##new folder");
  if (!begin_dialog("##new folder", look, ImVec2{440, 140})) return std::nullopt;
  title_text("New folder", look);
  ImGui::SetNextItemWidth(-1);
  if (std::exchange(wants_focus_, false)) ImGui::SetKeyboardFocusHere();
  if (ImGui::InputTextWithHint("##name", "Name of the folder", &name_,
                               ImGuiInputTextFlags_AutoSelectAll))
    problem_.clear();
  const float room = ImGui::GetContentRegionAvail().x;
  if (problem_.empty())
    dim_text(elided("In " + parent.string(), room), look);
  else
    ImGui::TextColored(look.palette->warning, "%s", elided(problem_, room).c_str());
  const DialogKeys keys = dialog_keys(TextKeys::dialog);
  std::optional<std::filesystem::path> made;
  if (main_button("Make it", look) || keys.takes) {
    problem_ = make_folder(parent, name_);
    wants_focus_ = true;
    if (problem_.empty()) made = parent / name_;
  }
  ImGui::SameLine();
  if (ImGui::Button("Cancel") || keys.leaves || made) ImGui::CloseCurrentPopup();
  end_dialog();
  return made;
}

}  // namespace foldless
