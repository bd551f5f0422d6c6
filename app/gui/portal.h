// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/gui/file_request.h"

namespace foldless {

/// How the desktop's dialog ended.
struct PortalAnswer {
  enum class Kind {
    chosen,
    dismissed,  ///< by the user
    failed      ///< nobody was asked, or what was chosen is no file of this machine
  };
  Kind kind = Kind::failed;
  std::filesystem::path file;  ///< that was chosen
};

/// The file dialog of the desktop: org.freedesktop.portal.FileChooser on the session's bus. Nothing
/// here waits: what is on its way is taken by update().
class Portal {
 public:
  /// Looks for it on the bus of that address; an empty one is none. `parent_window` as portals
  /// name windows, `x11:1a2b`; may be empty.
  Portal(const std::string& address, std::string parent_window);
  ~Portal();
  Portal(const Portal&) = delete;
  Portal& operator=(const Portal&) = delete;

  void update();
  /// Something is on its way: update() has to be called again soon.
  bool is_waiting() const;
  /// There is such a dialog, as far as is known now.
  bool is_there() const;

  /// Opens the dialog; the one before is withdrawn. Only where it is there.
  void ask(const FileRequest& request);
  /// How it ended, once.
  std::optional<PortalAnswer> take_answer();
  /// Closes it unanswered.
  void withdraw();

 private:
  struct Bus;
  std::unique_ptr<Bus> bus_;  ///< null: there is none
};

/// Where the user's session has its bus, empty where it has none. Starts none.
std::string session_bus_address();

}  // namespace foldless
