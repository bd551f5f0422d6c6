// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

#include "core/error.h"
#include "core/files/left_over.h"

namespace foldless {
namespace {

namespace fs = std::filesystem;

using Parts = std::span<const std::string_view>;

/// Of a file that is read: a mesh of ten million triangles has less.
constexpr std::size_t kMostBytes = std::size_t{1} << 30;

/// For somebody to write into a pipe that is read.
constexpr std::chrono::seconds kLongestWait{5};

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

/// An open file that is closed when it goes out of scope.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
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

int write_all(int descriptor, Parts parts) {
  for (const std::string_view bytes : parts)
    if (const int error = write_all(descriptor, bytes)) return error;
  return 0;
}

/// The hidden names that are tried, in order: so what a process left that was killed is found
/// without looking through the folder, where there may be many thousands of frames.
fs::path temporary_name(const fs::path& file, int number) {
  std::string digits = std::to_string(number);
  digits.insert(0, 6 - std::min<std::size_t>(6, digits.size()), '0');
  return file.parent_path() / (staged_prefix(file) + digits);
}

/// Makes a file that was not there, with the permissions of the one that is to be replaced, or else
/// those that a new file gets; its name stays in `temporary`, empty when it could not be made. (Not
/// mkstemp: what a new file gets can only be asked of the whole process, by changing it.)
Descriptor make_beside(const fs::path& file, fs::path& temporary) {
  int tried = 0;
  for (;;) {
    fs::path name = temporary_name(file, tried);
    Descriptor made(::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (!made.is_open() && errno != EEXIST) return made;
    if (!made.is_open()) {
      if (!remove_left_over(name)) ++tried;
      continue;
    }
    temporary.swap(name);
    if (lock_new(made.number(), temporary)) {
      while (remove_left_over(temporary_name(file, tried + 1))) ++tried;
      return made;
    }
    temporary.clear();
  }
}

/// The name of a file that is removed where it has not got another one, also where memory runs
/// short on the way.
struct Temporary {
  Temporary() = default;
  ~Temporary() {
    if (!name.empty()) ::unlink(name.c_str());
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  fs::path name;
};

int keep_permissions(const fs::path& file, int descriptor) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return 0;
  return ::fchmod(descriptor, status.st_mode & 07777) == 0 ? 0 : errno;
}

/// Writes a new file under a name of its own beside `file`; its name stays in `temporary`, and
/// while `lock` lives no process takes it for a leftover.
int write_beside(const fs::path& file, Parts parts, fs::path& temporary,
                 std::optional<Descriptor>& lock) {
  Descriptor out = make_beside(file, temporary);
  if (!out.is_open()) return errno;
  lock.emplace(::fcntl(out.number(), F_DUPFD_CLOEXEC, 0));
  if (const int error = write_all(out.number(), parts)) return error;
  if (const int error = keep_permissions(file, out.number())) return error;
  if (::fsync(out.number()) != 0) return errno;
  return out.close();
}

void write_in_place(const fs::path& file, Parts parts) {
  Descriptor out(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
  if (!out.is_open()) refuse_writing(file, errno);
  int error = write_all(out.number(), parts);
  if (error == 0) error = out.close();
  if (error != 0) refuse_writing(file, error);
}

/// Waits until somebody writes into a pipe; a character that was read on the way goes to `bytes`.
void wait_for_writer(const fs::path& file, int descriptor, std::string& bytes) {
  using namespace std::chrono_literals;
  char first = 0;
  for (auto waited = 0ms; waited < kLongestWait; waited += 20ms) {
    const ssize_t n = ::read(descriptor, &first, 1);
    if (n > 0) bytes += first;
    if (n != 0) return;  // without a writer a pipe is at its end
    std::this_thread::sleep_for(20ms);
  }
  throw Error(file.string() + ": is a pipe that nobody writes to; begin the program that does");
}

}  // namespace

void refuse_writing(const fs::path& file, int error) {
  throw Error(file.string() + ": cannot be written: " + reason(error) + advice(error));
}

void read_blocks(const fs::path& file, const std::function<void(std::string_view)>& take) {
  // Without O_NONBLOCK a pipe is opened when somebody opens its other end, perhaps never.
  const Descriptor in(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (!in.is_open()) refuse_reading(file, errno);
  std::size_t size = 0;
  const auto add = [&](std::string_view bytes) {
    size += bytes.size();
    if (size > kMostBytes)
      throw Error(file.string() + ": has more than " + std::to_string(kMostBytes) +
                  " bytes, the most that is read");
    take(bytes);
  };
  struct stat status {};
  if (::fstat(in.number(), &status) == 0 && S_ISFIFO(status.st_mode)) {
    std::string first;
    wait_for_writer(file, in.number(), first);
    add(first);
  }
  ::fcntl(in.number(), F_SETFL, O_RDONLY);  // what comes later is waited for
  char block[1 << 16];
  for (;;) {
    const ssize_t n = ::read(in.number(), block, sizeof block);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) refuse_reading(file, errno);
    if (n == 0) return;
    add({block, static_cast<std::size_t>(n)});
  }
}

std::string read_file(const fs::path& file) {
  std::string bytes;
  std::error_code ignored;
  const std::uintmax_t size = fs::is_regular_file(file, ignored) ? fs::file_size(file, ignored) : 0;
  if (!ignored) bytes.reserve(std::min<std::uintmax_t>(size, kMostBytes));
  read_blocks(file, [&](std::string_view block) { bytes += block; });
  return bytes;
}

void write_file_atomically(const fs::path& file, std::string_view bytes) {
  write_file_atomically(file, std::span(&bytes, 1));
}

void write_file_atomically(const fs::path& file, Parts parts) {
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  if (fs::is_directory(status)) refuse_writing(file, EISDIR);
  if (fs::exists(status) && !fs::is_regular_file(status)) return write_in_place(file, parts);

  const fs::path resolved = fs::weakly_canonical(file, ignored);
  const fs::path target = ignored ? file : resolved;
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  std::optional<Descriptor> lock;
  Temporary temporary;
  int error = write_beside(target, parts, temporary.name, lock);
  if (error == 0 && ::rename(temporary.name.c_str(), target.c_str()) != 0) error = errno;
  if (error != 0) refuse_writing(file, error);
  temporary.name.clear();
  sync_folder(folder);
}

void write_new_file(const fs::path& file, std::string_view bytes, const fs::path& told) {
  write_new_file(file, std::span(&bytes, 1), told);
}

void write_new_file(const fs::path& file, Parts parts, const fs::path& told) {
  Descriptor out(::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (!out.is_open()) refuse_writing(told, errno);
  int error = write_all(out.number(), parts);
  if (error == 0 && ::fsync(out.number()) != 0) error = errno;
  if (error == 0) error = out.close();
  if (error != 0) refuse_writing(told, error);
}

std::string staged_prefix(const fs::path& result) {
  constexpr std::size_t kMostOfName = 200;
  return '.' + result.filename().string().substr(0, kMostOfName) + ".foldless-";
}

// A folder that cannot be synced is no failure: a file is complete under its name.
void sync_folder(const fs::path& folder) {
  const Descriptor in(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (in.is_open()) ::fsync(in.number());
}

}  // namespace foldless
