// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/hints.h"

#include "app/editor/mirroring.h"

namespace foldless {
namespace {

/// ` · F1 all keys`; nothing for a command without a key.
std::string key_hint(const Editor& editor, std::string_view command, const std::string& effect) {
  const std::string key = editor.keys().words(command);
  return key.empty() ? "" : std::string(" · ").append(key).append(" ").append(effect);
}

}  // namespace

std::string hint_words(const Editor& editor, const Modifiers& modifiers) {
  if (editor.files().image_import().is_open())
    return "Enter makes the mesh · Esc leaves everything as it was";
  if (editor.document().is_empty())
    return "Drop an image, a mesh or a scene here" + key_hint(editor, "file.open", "opens one");
  if (editor.race().is_open())
    return "Space pauses all lanes" + key_hint(editor, "solve.step", "goes on by one") +
           " · wheel zooms, drag moves · Esc closes";
  if (editor.playback().scrubbed())
    return "Enter goes on from this iteration · Esc returns to the newest";
  if (std::string words = editor.input().words(); !words.empty()) return words;
  if (editor.draft().is_editing()) return "Release to set the target · Esc takes the drag back";
  if (editor.brush().is_on())
    return "Drag paints stiffness · Shift takes it back · [ and ] change the size · Esc ends";
  if (editor.bone_tool().is_on())
    return editor.bone_tool().chain().empty()
               ? "Click places the root of bones, or takes a handle for it · Esc ends"
               : "Click adds the next joint · Enter or Esc ends these bones";
  if (editor.input().band() || !editor.input().lasso().empty())
    return "Release to select · Shift adds · Ctrl takes away · Esc cancels";
  if (editor.view().beside() == Beside::kept_pose && modifiers == Modifiers{} &&
      !editor.selection().hovered())
    return "The kept pose at the left, the one you edit at the right · Esc ends";
  if (modifiers.control)
    return "Ctrl+drag takes away from the selection" +
           key_hint(editor, "help.search", "finds commands");
  if (modifiers.shift) return "Shift+click adds to the selection · Shift+drag adds a box";
  if (editor.selection().hovered())
    return "Drag to bend" + key_hint(editor, "edit.delete", "removes what is selected") +
           " · Shift adds";
  if (editor.motion().is_open())
    return "A handle that is dragged gets a key here" + key_hint(editor, "solve.toggle", "plays") +
           " · diamonds: drag moves, Ctrl copies, Alt stretches";
  if (is_mirror_on(editor))
    return "Mirror: handles come in pairs and move in pairs · drag the axis by its ends" +
           key_hint(editor, "mirror.toggle", "ends");
  return "Click places a handle, drag bends · wheel zooms, middle drag pans" +
         key_hint(editor, "help.keys", "all keys");
}

}  // namespace foldless
