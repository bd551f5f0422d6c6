// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "app/gui/extent.h"
#include "app/gui/ui_event.h"

namespace foldless {

/// The window that a session is played in.
struct SessionWindow {
  Extent framebuffer;       ///< pixels
  Extent window;            ///< window coordinates, which pointer events use
  float content_scale = 1;  ///< pixels in a design pixel that the desktop asks for

  bool operator==(const SessionWindow&) const = default;
};

/// A picture of the whole window is taken.
struct Shot {
  std::string name;  ///< of its file, without `.png`
};

using SessionEvent = std::variant<UiEvent, SessionWindow, Shot>;

/// A line of a session after the first.
struct SessionEntry {
  double time = 0;  ///< since the beginning [s]
  SessionEvent event;
  int line = 0;  ///< of the file
};

/// What was opened when a session began.
struct SessionStart {
  std::filesystem::path file;  ///< absolute; empty: nothing
  bool is_sample = false;      ///< opened as a copy, which is saved elsewhere
};

/// What somebody did in the editor: JSON lines, one an event. The first names the window and the
/// file that was opened, `{"session": 1, "size": [1280, 800], "file": "cat.json"}`, or a `sample`;
/// paths are relative to the session's folder.
struct SessionFile {
  SessionWindow window;
  SessionStart start;
  std::vector<SessionEntry> entries;
};

/// Throws Error `FILE:LINE: ...` for what is no session.
SessionFile read_session(const std::filesystem::path& path);
/// As read_session() of a file of that name with this text; paths in it are relative to `folder`.
SessionFile parse_session(const std::string& text, const std::string& name,
                          const std::filesystem::path& folder);

// Lines to write, with their ends.

/// The first one; `folder` is that of the session.
std::string first_line(const SessionWindow& window, const SessionStart& start,
                       const std::filesystem::path& folder);
std::string line_of(double time, const SessionEvent& event);
std::string line_of(double time, const UiEvent& event);

}  // namespace foldless
