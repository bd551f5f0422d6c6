// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/left_over.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace foldless {
namespace {

namespace fs = std::filesystem;

/// Whether the descriptor is of what has the name now.
bool is_the_same(int descriptor, const fs::path& path) {
  struct stat a {
  }, b{};
  return ::fstat(descriptor, &a) == 0 && ::lstat(path.c_str(), &b) == 0 && a.st_dev == b.st_dev &&
         a.st_ino == b.st_ino;
}

}  // namespace

// It goes while we have the lock: who has just made it sees then that it is no longer there.
bool remove_left_over(const fs::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return false;
  bool is_removed = false;
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0 && is_the_same(descriptor, path)) {
    std::error_code failure;
    fs::remove_all(path, failure);
    is_removed = !failure;
  }
  ::close(descriptor);
  return is_removed;
}

bool lock_new(int descriptor, const fs::path& path) {
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return is_the_same(descriptor, path);
  return errno != EWOULDBLOCK;
}

}  // namespace foldless
