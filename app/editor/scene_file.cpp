// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/scene_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace foldless {

SceneFile::~SceneFile() { unlock(); }

void SceneFile::take(const std::filesystem::path& path, const std::optional<FileStamp>& stamp) {
  unlock();
  path_ = path;
  stamp_ = stamp;
  lock();
}

void SceneFile::leave() {
  unlock();
  path_.clear();
  stamp_.reset();
}

bool SceneFile::has_changed() const {
  const std::optional<FileStamp> now = stamp_of(path_);
  return now && now != stamp_;
}

/// All that have the file open share the lock; who could have had it alone is the first. Where
/// files cannot be locked nobody is seen, and what others write is seen by the stamp.
void SceneFile::lock() {
  is_shared_ = false;
  lock_ = open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (lock_ < 0) return;
  is_shared_ = flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  flock(lock_, LOCK_SH | LOCK_NB);
}

void SceneFile::unlock() {
  if (lock_ >= 0) close(std::exchange(lock_, -1));
  is_shared_ = false;
}

}  // namespace foldless
