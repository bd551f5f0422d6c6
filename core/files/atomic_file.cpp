// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include "core/error.h"

namespace foldless {
namespace {

namespace fs = std::filesystem;

/// Of a file that is read: a mesh of ten million triangles has less.
constexpr std::size_t kMostBytes = std::size_t{1} << 30;

std::string reason(int error) { return std::generic_category().message(error); }

[[noreturn]] void refuse_reading(const fs::path& file, int error) {
  throw Error(file.string() + ": cannot be read: " + reason(error));
}

/// What to do about a file that cannot be written; empty where that is another matter each time.
const char* advice(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT: return "; make room there, or choose another folder";
    case EFBIG:
    case EROFS:
    case EACCES:
    case EPERM:
    case ENOTDIR:
    case ENOENT: return "; choose another folder";
    default: return "";
  }
}

[[noreturn]] void refuse_writing(const fs::path& file, int error) {
  throw Error(file.string() + ": cannot be written: " + reason(error) + advice(error));
}

/// An open file that is closed when it goes out of scope.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }
  /// 0, or what went wrong.
  int close() { return ::close(std::exchange(number_, -1)) == 0 ? 0 : errno; }

 private:
  int number_;
};

/// 0, or what went wrong.
int write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(descriptor, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return 0;
}

/// Permissions of the file that is replaced, or those that a new file would have.
mode_t wanted_mode(const fs::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) == 0) return status.st_mode & 07777;
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

/// Writes a new file under a name of its own beside `file`; its name stays in `temporary`.
int write_beside(const fs::path& file, std::string_view bytes, std::string& temporary) {
  Descriptor out(::mkostemp(temporary.data(), O_CLOEXEC));
  if (!out.is_open()) {
    temporary.clear();
    return errno;
  }
  if (const int error = write_all(out.number(), bytes)) return error;
  if (::fchmod(out.number(), wanted_mode(file)) != 0) return errno;
  if (::fsync(out.number()) != 0) return errno;
  return out.close();
}

void write_in_place(const fs::path& file, std::string_view bytes) {
  Descriptor out(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
  if (!out.is_open()) refuse_writing(file, errno);
  int error = write_all(out.number(), bytes);
  if (error == 0) error = out.close();
  if (error != 0) refuse_writing(file, error);
}

}  // namespace

std::string read_file(const fs::path& file) {
  const Descriptor in(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (!in.is_open()) refuse_reading(file, errno);
  std::string bytes;
  struct stat status {};
  if (::fstat(in.number(), &status) == 0 && S_ISREG(status.st_mode))
    bytes.reserve(std::min(static_cast<std::size_t>(status.st_size), kMostBytes));
  char block[1 << 16];
  for (;;) {
    const ssize_t n = ::read(in.number(), block, sizeof block);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) refuse_reading(file, errno);
    if (n == 0) return bytes;
    if (bytes.size() + static_cast<std::size_t>(n) > kMostBytes)
      throw Error(file.string() + ": has more than " + std::to_string(kMostBytes) +
                  " bytes, the most that is read");
    bytes.append(block, static_cast<std::size_t>(n));
  }
}

void write_file_atomically(const fs::path& file, std::string_view bytes) {
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  if (fs::is_directory(status)) refuse_writing(file, EISDIR);
  if (fs::exists(status) && !fs::is_regular_file(status)) return write_in_place(file, bytes);

  const fs::path resolved = fs::weakly_canonical(file, ignored);
  const fs::path target = ignored ? file : resolved;
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  std::string temporary = (folder / ".").string();
  temporary.append(target.filename().string()).append(".XXXXXX");
  int error = write_beside(target, bytes, temporary);
  if (error == 0 && ::rename(temporary.c_str(), target.c_str()) != 0) error = errno;
  if (error != 0) {
    if (!temporary.empty()) ::unlink(temporary.c_str());
    refuse_writing(file, error);
  }
  sync_folder(folder);
}

// A folder that cannot be synced is no failure: a file is complete under its name.
void sync_folder(const fs::path& folder) {
  const Descriptor in(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (in.is_open()) ::fsync(in.number());
}

}  // namespace foldless
