// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <signal.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <system_error>
#include <utility>

#include "tests/support/entries_below.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {

/// A folder that can be made full or read-only. Who may mount gets a small disk of its own there;
/// else no file of the process may grow while it is full, and permissions are taken away.
class TroubledDisk {
 public:
  TroubledDisk()
      : is_mounted_(mount("tmpfs", path().c_str(), "tmpfs", MS_NOSUID | MS_NODEV, kSize) == 0),
        old_handler_(signal(SIGXFSZ, SIG_IGN)) {}
  ~TroubledDisk() {
    end();
    signal(SIGXFSZ, old_handler_);
    if (is_mounted_) umount2(path().c_str(), MNT_DETACH);
  }
  TroubledDisk(const TroubledDisk&) = delete;
  TroubledDisk& operator=(const TroubledDisk&) = delete;

  const std::filesystem::path& path() const { return folder_.path(); }
  std::filesystem::path operator/(std::string_view name) const { return folder_ / name; }

  void fill() {
    if (!is_mounted_) return limit_files(kFewBytes);
    std::ofstream filler(path() / kFiller, std::ios::binary);
    while (filler << std::string(4096, 'x') << std::flush) continue;
  }
  void make_read_only() {
    if (!is_mounted_) return permit(std::filesystem::perms(0555));
    // Over it, as the disk itself stays writable while a file on it is open to be written.
    is_covered_ =
        mount(path().c_str(), path().c_str(), nullptr, MS_BIND, nullptr) == 0 &&
        mount(nullptr, path().c_str(), nullptr, MS_REMOUNT | MS_BIND | MS_RDONLY, nullptr) == 0;
  }
  /// Room again, and leave to write.
  void end() {
    if (std::exchange(is_covered_, false)) umount2(path().c_str(), MNT_DETACH);
    if (is_mounted_) {
      std::filesystem::remove(path() / kFiller);
    } else {
      limit_files(RLIM_INFINITY);
      permit(std::filesystem::perms(0755));
    }
  }

 private:
  static constexpr const char* kSize = "size=1m";
  static constexpr const char* kFiller = "filler";
  static constexpr rlim_t kFewBytes = 20;

  /// Folders and what is in them, but not files: those are replaced, not written to.
  void permit(std::filesystem::perms permissions) const {
    std::filesystem::permissions(path(), permissions);
    std::error_code gone;
    for (const auto& entry : entries_below(path()))
      if (std::filesystem::is_directory(entry, gone))
        std::filesystem::permissions(entry, permissions, gone);
  }

  static void limit_files(rlim_t bytes) {
    rlimit limit{};
    getrlimit(RLIMIT_FSIZE, &limit);
    limit.rlim_cur = std::min(bytes, limit.rlim_max);
    setrlimit(RLIMIT_FSIZE, &limit);
  }

  TemporaryFolder folder_;
  bool is_mounted_;
  bool is_covered_ = false;
  void (*old_handler_)(int);
};

}  // namespace foldless::test
