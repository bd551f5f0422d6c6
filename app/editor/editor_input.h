// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/commands.h"
#include "app/editor/input.h"
#include "app/editor/tool.h"

namespace foldless {

/// Pointer and keys of an editor: the gesture that is under way, and keys that are held.
class EditorInput {
 public:
  /// Keeps a reference.
  explicit EditorInput(Editor& editor);

  void receive(const InputEvent& event);
  /// True when no gesture is under way.
  bool is_idle() const { return tool_->is_idle(); }
  /// Cancels the gesture that is under way; returns whether there was one.
  bool cancel_gesture();
  /// Begins one that no press begins.
  void begin(std::unique_ptr<Tool> tool);
  /// To draw, see Tool.
  std::optional<PixelBox> band() const { return tool_->band(); }
  std::vector<Vec2> lasso() const { return tool_->lasso(); }
  std::string words() const { return tool_->words(); }
  /// Where it was last, in pixels of the canvas.
  const Vec2& pointer() const { return pointer_; }
  /// Of the key that was pressed last, until it is released.
  const Modifiers& modifiers() const { return modifiers_; }
  bool is_lasso_held() const { return is_lasso_held_; }
  bool is_space_held() const { return space_.has_value(); }

 private:
  struct SpaceKey {
    double since = 0;
    bool has_panned = false;
  };

  void on(const PointerPressed& event);
  void on(const PointerMoved& event);
  void on(const PointerReleased& event);
  void on(const PointerLeft& event);
  void on(const WheelTurned& event);
  void on(const KeyPressed& event);
  void on(const KeyReleased& event);
  void on(const FilesDropped& event);
  void on(const FocusLost& event);
  void take_over(std::unique_ptr<Tool> next);

  Editor& editor_;
  std::unique_ptr<Tool> tool_;
  Vec2 pointer_ = Vec2::Zero();
  std::optional<SpaceKey> space_;
  bool is_lasso_held_ = false;
  Modifiers modifiers_;
  const Command* held_command_ = nullptr;  ///< whose key is down, if it lasts as long as that
  Key held_key_ = Key::none;
};

}  // namespace foldless
