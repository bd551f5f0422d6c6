// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/video_file.h"

#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/files/atomic_file.h"
#include "core/files/staged.h"
#include "core/files/text_lines.h"

namespace foldless {
namespace {

namespace fs = std::filesystem;

/// A file descriptor of our own.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const { return number_; }
  void close() {
    if (number_ >= 0) ::close(std::exchange(number_, -1));
  }

 private:
  int number_;
};

/// What is told ffmpeg to make: pictures come as bytes on its standard input.
std::vector<std::string> arguments_for(const fs::path& path, const Image& first, double fps) {
  std::string rate;
  append_number(rate, fps);
  std::vector<std::string> arguments{
      "ffmpeg", "-hide_banner", "-loglevel", "error", "-xerror", "-nostdin", "-y", "-f", "rawvideo",
      "-pix_fmt", "rgba", "-s", std::to_string(first.width) + "x" + std::to_string(first.height),
      "-r", rate, "-i", "pipe:0",
      // Codecs halve the resolution of colours: sides are even.
      "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2"};
  const auto add = [&](std::initializer_list<const char*> more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
  };
  if (path.extension() == ".mp4")
    add({"-c:v", "libx264", "-crf", "18", "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-f",
         "mp4"});
  else
    add({"-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-pix_fmt", "yuva420p", "-f", "webm"});
  return arguments;
}

class VideoFile : public FilmOutput {
 public:
  VideoFile(fs::path path, const FilmOptions& options)
      : path_(std::move(path)), fps_(options.fps) {}
  ~VideoFile() override {
    if (process_ > 0) {
      kill(process_, SIGKILL);
      wait_for_end();
    }
  }

  void add(const Image& image) override {
    if (process_ < 0) begin(image);
    const char* bytes = reinterpret_cast<const char*>(image.pixels.data());
    std::size_t left = image.pixels.size();
    while (left > 0) {
      // A socket rather than a pipe: where ffmpeg has ended this fails without a signal.
      const ssize_t written = send(pictures_.number(), bytes, left, MSG_NOSIGNAL);
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) end_too_early();
      bytes += written;
      left -= static_cast<std::size_t>(written);
    }
  }

  void finish() override {
    end();
    staged_->take_name();
  }

 private:
  void begin(const Image& first) {
    staged_.emplace(path_, Staged::What::file);
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
      throw Error(path_.string() + ": nothing can be passed to ffmpeg: " + std::strerror(errno));
    const Descriptor input(ends[0]);
    pictures_ = Descriptor(ends[1]);
    complaints_ = Descriptor(memfd_create("ffmpeg", MFD_CLOEXEC));
    std::vector<std::string> arguments = arguments_for(path_, first, fps_);
    arguments.push_back(staged_->path().string());
    std::vector<char*> pointers;
    pointers.reserve(arguments.size() + 1);
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input.number(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, complaints_.number(), STDERR_FILENO);
    const int problem =
        posix_spawnp(&process_, "ffmpeg", &actions, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (problem == 0) return;
    process_ = -1;
    if (problem == ENOENT)
      throw Error(path_.string() + ": videos are made by ffmpeg, which is not there; install it, " +
                  "or write .webp or .gif");
    throw Error(path_.string() + ": ffmpeg cannot be started: " + std::strerror(problem));
  }

  int wait_for_end() {
    int status = 0;
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
    return status;
  }

  /// There are no more pictures. Throws Error with what ffmpeg said where it failed. Its status
  /// does not tell that: it can be 0 on a full disk.
  void end() {
    pictures_.close();
    const int status = wait_for_end();
    const std::string said = complaints();
    if (said.find("No space left") != said.npos) refuse_writing(path_, ENOSPC);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0 && said.empty()) return;
    const std::string last = said.substr(said.rfind('\n') == said.npos ? 0 : said.rfind('\n') + 1);
    throw Error(path_.string() + ": ffmpeg failed" + (last.empty() ? "" : ": " + last));
  }

  [[noreturn]] void end_too_early() {
    end();  // It tells why, as a rule.
    throw Error(path_.string() + ": ffmpeg ended before it had all pictures");
  }

  /// What ffmpeg said, the last of it, with the name that the file is to have.
  std::string complaints() const {
    constexpr off_t kMost = 1 << 16;
    const off_t size = lseek(complaints_.number(), 0, SEEK_END);
    std::string said(static_cast<std::size_t>(std::clamp<off_t>(size, 0, kMost)), '\0');
    const ssize_t count =
        pread(complaints_.number(), said.data(), said.size(), std::max<off_t>(0, size - kMost));
    said.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    while (!said.empty() && said.back() == '\n') said.pop_back();
    const std::string hidden = staged_->path().string();
    for (std::size_t at = 0; (at = said.find(hidden, at)) != said.npos; at += path_.string().size())
      said.replace(at, hidden.size(), path_.string());
    return said;
  }

  fs::path path_;
  std::optional<Staged> staged_;
  double fps_;
  pid_t process_ = -1;
  Descriptor pictures_, complaints_;
};

}  // namespace

bool has_ffmpeg() {
  const char* const variable = std::getenv("PATH");
  std::istringstream folders(variable ? variable : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (access((fs::path(folder) / "ffmpeg").c_str(), X_OK) == 0) return true;
  return false;
}

std::unique_ptr<FilmOutput> video_file(const fs::path& path, const FilmOptions& options) {
  return std::make_unique<VideoFile>(path, options);
}

}  // namespace foldless
