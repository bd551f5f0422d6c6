// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <imgui.h>

#include <span>

#include "app/gui/look.h"

namespace foldless {

/// Pictures of the icon font that is installed beside the program (Material Design Icons), each a
/// character of it.
enum class Icon : ImWchar {
  play = 0xF40A,
  pause = 0xF3E4,
  step = 0xF4D7,
  back = 0xF4D5,
  first = 0xF4AE,
  last = 0xF4AD,
  stop = 0xF4DB,
  film = 0xF230,
  up = 0xF05D,
  reset = 0xF450,
  pointer = 0xF1B4,
  brush = 0xF0E3,
  pin = 0xF403,
  turn = 0xF467,
  scale = 0xF616,
  forward = 0xF03D,
  backward = 0xF03F,
  remove = 0xF1C0,
  undo = 0xF54C,
  redo = 0xF44E,
  reset_pose = 0xF06F,
  fit = 0xF2F1,
  mesh = 0xF563,
  compare = 0xF18A,
  race = 0xF23C,
  picture = 0xF2E9,
  bones = 0xF0B9,
  mirror = 0xF61E,
  record = 0xF44A,
  key = 0xF30A,
  onion_skin = 0xF328,
  time_line = 0xF52F,
};

/// First and last of each range of characters, ended by 0 as ImGui wants it.
std::span<const ImWchar> icon_ranges();

/// The square that an icon is in the middle of.
struct IconPlace {
  ImVec2 corner;
  float side = 0;
};

/// In the larger of two sizes where it has room.
void draw_icon(Icon icon, const IconPlace& place, ImU32 colour, const Look& look);

}  // namespace foldless
