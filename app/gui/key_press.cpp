// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/key_press.h"

#include <imgui.h>

namespace foldless {

void forget_key(int index) {
  ImGuiIO& io = ImGui::GetIO();
  io.KeysDown[index] = false;
  io.KeysDownDuration[index] = -1;
}

bool take_press(int index) {
  if (!ImGui::IsKeyPressed(index, false)) return false;
  forget_key(index);
  return true;
}

}  // namespace foldless
