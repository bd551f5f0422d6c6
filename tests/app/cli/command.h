// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/cli/command_line.h"
#include "core/method/method.h"

namespace foldless::test {

/// How a call of the program ended.
struct Ended {
  int status = -1;  ///< exit status; negative: the signal that killed it
  std::string out;  ///< what it printed on stdout
  std::string err;  ///< and on stderr
  double peak = 0;  ///< the most memory that it had [MiB]
};

/// The program with these arguments in a process of its own, without a display.
class Command {
 public:
  explicit Command(const std::vector<std::string>& arguments, const EditorCalls& editor = {});
  /// With stdout into a device, or closed where `out` is empty.
  Command(const std::vector<std::string>& arguments, const std::filesystem::path& out);
  ~Command();
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;

  void send(int signal) const;
  /// Whether it has not ended yet.
  bool is_running() const;
  /// The processor time that it has taken, whatever else the machine does [s].
  double processor_seconds() const;
  /// Waits for its end.
  Ended wait();

 private:
  /// True in the new process.
  bool fork_off();

  std::filesystem::path folder_;
  pid_t process_ = -1;
};

/// Runs the program to its end.
Ended run(const std::vector<std::string>& arguments);

/// Does something in a process of its own; whether that ended as it should. To draw pictures, for
/// one: OpenGL in memory has threads, without which it waits for ever in processes that are forked
/// later.
bool in_own_process(const std::function<void()>& action);

/// Sends the program a signal as soon as `is_time`. Where it was quicker than that was seen,
/// `clear` removes what it left, and it is begun again.
Ended interrupt(const std::vector<std::string>& arguments, int signal,
                const std::function<bool(const Command&)>& is_time,
                const std::function<void()>& clear);

/// A folder that goes with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Writes a scene file whose mesh is inline.
void write_scene(const std::string& file, const Problem& problem);

void write_text(const std::string& file, const std::string& text);
std::string read_text(const std::string& file);
/// Names of the files in a folder, sorted; none when it does not exist.
std::vector<std::string> names_in(const std::filesystem::path& folder);

}  // namespace foldless::test
