// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/editor/editor.h"
#include "app/gui/look.h"

namespace foldless {

struct Action;
struct UiState;

/// Ctrl+K: finds a command by a few of its letters and runs it.
class CommandSearch {
 public:
  void open();
  void draw(Editor& editor, UiState& state, const Look& look);

 private:
  void draw_rows(std::vector<Action> actions, bool is_taken, const Look& look);

  std::string text_;
  std::size_t selected_ = 0;
  bool opens_now_ = false;
};

}  // namespace foldless
