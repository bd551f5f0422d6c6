// SPDX-License-Identifier: GPL-3.0-or-later
// Is loaded into the program before all libraries and makes one call fail, or ends the program
// before it. FOLDLESS_FAULT is `KIND:N` or `KIND:N:kill`, N from 1; calls that concern files count
// where the file lies in the folder FOLDLESS_FAULT_IN. When it happens, the file
// FOLDLESS_FAULT_MARK is made. Counting begins with the call of signal() that is the program's
// first statement. Of KIND `new` is every allocation, of `place` the first of those that the same
// calls lead to. With `frame:1` the next allocation of the main thread fails after SIGUSR2.
// Allocations of libraries that are loaded later do not count: Mesa is of C, and after
// std::bad_alloc of LLVM, which it calls, has passed through it, its locks are held for ever.
#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <string_view>

#include "tests/faults/callers.h"

namespace {

using foldless::test::find_objects;
using foldless::test::is_asked_by_program;
using foldless::test::is_new_place;

template <typename Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

/// Plain memory: it is read before anything of the program has begun.
struct Fault {
  char kind[16] = "";
  long call = 0;
  bool kills = false;
  char folder[PATH_MAX] = "";

  Fault() {
    const char* fault = std::getenv("FOLDLESS_FAULT");
    const char* in = std::getenv("FOLDLESS_FAULT_IN");
    char end[8] = "";
    if (!fault || std::sscanf(fault, "%15[a-z]:%ld:%7s", kind, &call, end) < 2) call = 0;
    kills = std::string_view(end) == "kill";
    if (in) std::strncpy(folder, in, sizeof folder - 1);
  }

  bool concerns(std::string_view path) const { return path.starts_with(folder); }
};

const Fault& fault() {
  static const Fault the_fault;
  return the_fault;
}

/// The first that the program itself does, after what comes before main().
std::atomic<bool> has_begun = false;

/// Whether this call of that kind is the one. Does not return where that ends the program.
bool is_it(std::string_view kind) {
  static std::atomic<long> calls = 0;
  if (!has_begun || kind != fault().kind || ++calls != fault().call) return false;
  if (const char* mark = std::getenv("FOLDLESS_FAULT_MARK"))
    next<int(int)>("close")(
        next<int(const char*, int, ...)>("open")(mark, O_CREAT | O_WRONLY, 0600));
  if (fault().kills) kill(getpid(), SIGKILL);
  return true;
}

bool is_it(std::string_view kind, const char* path) {
  return fault().concerns(path) && is_it(kind);
}

bool is_it(std::string_view kind, int descriptor) {
  char link[64], path[PATH_MAX];
  std::snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
  const ssize_t length = readlink(link, path, sizeof path - 1);
  if (length < 0) return false;
  path[length] = '\0';
  return is_it(kind, path);
}

bool is_allocation() {
  const std::string_view kind = fault().kind;
  const bool is_place = kind == "place";
  if (!has_begun || !(is_place || kind == "new") || !is_asked_by_program()) return false;
  return (!is_place || is_new_place()) && is_it(kind);
}

std::atomic<bool> is_armed = false;

void arm(int) { is_armed = true; }

bool is_frame() { return is_armed && gettid() == getpid() && is_armed.exchange(false); }

int failed(int error) {
  errno = error;
  return -1;
}

bool makes(int flags) { return (flags & O_CREAT) != 0; }

int mode_of(int flags, va_list arguments) { return makes(flags) ? va_arg(arguments, int) : 0; }

}  // namespace

// The names of what is stood in for.
// NOLINTBEGIN(readability-identifier-naming, cert-dcl58-cpp)
extern "C" {

sighandler_t signal(int number, sighandler_t handler) noexcept {
  find_objects();
  if (!has_begun.exchange(true) && std::string_view(fault().kind) == "frame")
    next<sighandler_t(int, sighandler_t)>("signal")(SIGUSR2, arm);
  return next<sighandler_t(int, sighandler_t)>("signal")(number, handler);
}

int open(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const int mode = mode_of(flags, arguments);
  va_end(arguments);
  if (is_it(makes(flags) ? "open" : "reopen", path)) return failed(EMFILE);
  return next<int(const char*, int, ...)>("open")(path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const int mode = mode_of(flags, arguments);
  va_end(arguments);
  if (is_it(makes(flags) ? "open" : "reopen", path)) return failed(EMFILE);
  return next<int(const char*, int, ...)>("open64")(path, flags, mode);
}

ssize_t read(int descriptor, void* bytes, size_t count) {
  if (is_it("read", descriptor)) return failed(EIO);
  return next<ssize_t(int, void*, size_t)>("read")(descriptor, bytes, count);
}

ssize_t write(int descriptor, const void* bytes, size_t count) {
  if (is_it("write", descriptor)) return failed(ENOSPC);
  return next<ssize_t(int, const void*, size_t)>("write")(descriptor, bytes, count);
}

int fsync(int descriptor) {
  struct stat status {};
  const bool is_folder = fstat(descriptor, &status) == 0 && S_ISDIR(status.st_mode);
  if (is_it(is_folder ? "syncfolder" : "fsync", descriptor)) return failed(EIO);
  return next<int(int)>("fsync")(descriptor);
}

int close(int descriptor) {
  if (is_it("close", descriptor)) {
    next<int(int)>("close")(descriptor);
    return failed(EIO);
  }
  return next<int(int)>("close")(descriptor);
}

int rename(const char* from, const char* to) noexcept {
  if (is_it("rename", to)) return failed(EACCES);
  return next<int(const char*, const char*)>("rename")(from, to);
}

DIR* opendir(const char* path) {
  if (is_it("list", path)) {
    errno = EMFILE;
    return nullptr;
  }
  return next<DIR*(const char*)>("opendir")(path);
}

int flock(int descriptor, int operation) noexcept {
  if (is_it("lock", descriptor)) return failed(ENOLCK);
  return next<int(int, int)>("flock")(descriptor, operation);
}

char* mkdtemp(char* path) {
  if (is_it("mkdir", path)) {
    errno = ENOSPC;
    return nullptr;
  }
  return next<char*(char*)>("mkdtemp")(path);
}

int mkdir(const char* path, mode_t mode) noexcept {
  if (is_it("mkdir", path)) return failed(ENOSPC);
  return next<int(const char*, mode_t)>("mkdir")(path, mode);
}

int unlink(const char* path) noexcept {
  if (is_it("unlink", path)) return failed(EACCES);
  return next<int(const char*)>("unlink")(path);
}

int remove(const char* path) noexcept {
  if (is_it("unlink", path)) return failed(EACCES);
  return next<int(const char*)>("remove")(path);
}

}  // extern "C"

void* operator new(std::size_t size) {
  if (is_allocation() || is_frame()) throw std::bad_alloc();
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}

void* operator new[](std::size_t size) { return operator new(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
// NOLINTEND(readability-identifier-naming, cert-dcl58-cpp)
