// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gio/gio.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tests/support/child.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {

/// A bus of its own, which starts no services. Its address is empty where dbus-daemon is missing.
class PrivateBus {
 public:
  PrivateBus();
  const std::string& address() const { return address_; }

 private:
  TemporaryFolder folder_;
  std::unique_ptr<Child> daemon_;
  std::string address_;
};

/// A desktop's portal, answering for the user. Everything happens within update().
class FakePortal {
 public:
  /// Without `has_files` it is one that has no dialog for files.
  explicit FakePortal(const std::string& address, bool has_files = true);
  ~FakePortal();
  FakePortal(const FakePortal&) = delete;
  FakePortal& operator=(const FakePortal&) = delete;

  void update();
  /// What was asked for, `OpenFile ('x11:1', 'Open', {...})`, as GLib prints arguments.
  const std::vector<std::string>& calls() const { return calls_; }
  /// How many requests were closed by who asked.
  int closed() const { return closed_; }
  /// Ends the last request: 0 a file was chosen, 1 the user left, 2 something went wrong.
  void answer(guint32 code, const std::filesystem::path& file = {});

 private:
  void publish(const std::string& path, const char* interface);
  void take_call(const char* method, GVariant* arguments, GDBusMethodInvocation* call);

  GMainContext* context_;
  GDBusConnection* connection_;
  std::vector<std::string> calls_;
  std::string request_;  ///< the path of the last one
  int closed_ = 0;
};

}  // namespace foldless::test
