// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/canvas.h"
#include "app/editor/input.h"

namespace foldless {

class Editor;

/// What the pointer does between a press and its release: a small state that ignores everything
/// by default. A handler returns the tool that takes over, or null to stay.
class Tool {
 public:
  virtual ~Tool() = default;

  virtual std::unique_ptr<Tool> press(Editor&, const PointerPressed&) { return nullptr; }
  virtual std::unique_ptr<Tool> move(Editor&, const PointerMoved&) { return nullptr; }
  virtual std::unique_ptr<Tool> release(Editor&, const PointerReleased&) { return nullptr; }
  /// Takes back what the gesture did so far; the editor goes back to the idle tool.
  virtual void cancel(Editor&) {}

  /// True when no gesture is under way.
  virtual bool is_idle() const { return false; }
  /// True while the gesture changes the document.
  virtual bool is_editing() const { return false; }
  /// A key before the commands see it; true when it was for the tool, `next` then as above.
  virtual bool key(Editor&, const KeyPressed&, std::unique_ptr<Tool>& next) {
    next = nullptr;
    return false;
  }
  /// The selection band to draw, if there is one.
  virtual std::optional<PixelBox> band() const { return std::nullopt; }
  /// The line round what is selected, in pixels; empty when there is none.
  virtual std::vector<Vec2> lasso() const { return {}; }
  /// What the gesture does so far, and how it ends; empty where that is plain.
  virtual std::string words() const { return {}; }
};

/// The tool that waits for a gesture to begin.
std::unique_ptr<Tool> make_idle_tool();

}  // namespace foldless
