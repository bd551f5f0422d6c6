// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/key_presets.h"

#include <algorithm>

namespace foldless {
namespace {

constexpr Modifiers kPlain{};
constexpr Modifiers kWithAlt{.alt = true};
constexpr Modifiers kWithControl{.control = true};
constexpr Modifiers kWithControlShift{.shift = true, .control = true};
constexpr Modifiers kWithAll{.shift = true, .control = true, .alt = true};

/// Only what means the same there and here.
std::vector<KeyPreset> presets() {
  return {
      {kOwnKeys, "Foldless", {}},
      {"photoshop",
       "Photoshop",
       {
           {"select.none", {{Key::d, kWithControl}}},
           {"select.invert", {{Key::i, kWithControlShift}}},
           {"view.fit", {{Key::digit_0, kWithControl}}},
           {"view.actual_size", {{Key::digit_1, kWithControl}}},
           {"view.zoom_in", {{Key::plus, kWithControl}, {Key::plus, kWithControlShift}}},
           {"view.zoom_out", {{Key::minus, kWithControl}}},
           {"handle.turn", {{Key::t, kWithControl}}},
           {"handle.forward", {{Key::right_bracket, kWithControl}}},
           {"handle.back", {{Key::left_bracket, kWithControl}}},
           {"file.export", {{Key::w, kWithAll}}},
           {"help.search", {{Key::f, kWithControl}}},
           {"edit.keys", {{Key::k, kWithAll}}},
       }},
      {"blender",
       "Blender",
       {
           {"select.all", {{Key::a, kPlain}}},
           {"select.none", {{Key::a, kWithAlt}}},
           {"edit.delete", {{Key::x, kPlain}, {Key::del, kPlain}}},
           {"edit.reset_pose", {{Key::g, kWithAlt}}},
           {"handle.move", {{Key::g, kPlain}}},
           {"bones.draw", {{Key::e, kPlain}}},
           {"mirror.toggle", {{Key::m, kWithControl}}},
           {"view.panels", {{Key::n, kPlain}}},
           {"view.workspace.switch", {{Key::page_down, kWithControl}}},
           {"help.search", {{Key::f3, kPlain}}},
       }},
  };
}

}  // namespace

std::span<const KeyPreset> key_presets() {
  static const std::vector<KeyPreset> table = presets();
  return table;
}

const KeyPreset* find_key_preset(std::string_view name) {
  const auto table = key_presets();
  const auto it = std::ranges::find(table, name, &KeyPreset::name);
  return it == table.end() ? nullptr : &*it;
}

}  // namespace foldless
