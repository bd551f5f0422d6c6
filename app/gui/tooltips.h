// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <imgui.h>

#include <optional>
#include <string>

#include "app/gui/layout.h"
#include "app/gui/look.h"

namespace foldless {

/// What a tooltip is placed by.
struct TooltipSite {
  Rectangle item;
  Rectangle surroundings;  ///< the window of the item
  Rectangle display;
};

/// Where a tooltip of that size is nearest to its item beside the item's surroundings, so that it
/// covers neither the item nor what is next to it. Inside of the display; under or over the item
/// when no side has room.
Rectangle tooltip_place(const TooltipSite& site, const ImVec2& size, float gap);

/// Tooltips appear when the mouse has rested on an item for half a second, and stay while it is
/// there.
class Tooltips {
 public:
  /// After ImGui::NewFrame(). `time`: a clock that never goes back [s].
  void begin_frame(double time);
  /// Draws the tooltip of the last item when it is due.
  void show(const std::string& text, const Look& look);
  /// When the next one is due, if the mouse rests on.
  std::optional<double> due() const;
  /// One appeared in this frame.
  bool has_appeared() const { return shown_ && shown_ != shown_before_; }

 private:
  /// An item by its place.
  struct Item {
    float x, y, width, height;
    bool operator==(const Item&) const = default;
  };
  bool is_due() const;

  double time_ = 0;
  ImVec2 pointer_{};
  std::optional<double> rests_since_;  ///< nothing: it has not moved since a button was pressed
  std::optional<Item> shown_, shown_before_;
  bool is_awaited_ = false;
};

}  // namespace foldless
