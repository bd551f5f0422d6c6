// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/command.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "core/scene/scene_io.h"

namespace foldless::test {
namespace {

namespace fs = std::filesystem;

void redirect(int stream, const fs::path& file) {
  const int target = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(target, stream);
  close(target);
}

/// In the child process: never returns.
[[noreturn]] void call(const std::vector<std::string>& arguments, const EditorCalls& editor) {
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  std::vector<const char*> argv{"foldless"};
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  const int status = run_command_line(static_cast<int>(argv.size()), argv.data(), editor);
  std::cout.flush();
  std::cerr.flush();
  // Not exit(): the test program's own clean-up belongs to its parent.
  _exit(status);
}

fs::path new_folder() {
  std::string name = (fs::temp_directory_path() / "foldless-test-XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder: " + name);
  return name;
}

}  // namespace

bool Command::fork_off() {
  folder_ = new_folder();
  std::cout.flush();
  std::cerr.flush();
  process_ = fork();
  if (process_ < 0) throw std::runtime_error("no process for a call of the program");
  if (process_ > 0) return false;
  redirect(STDOUT_FILENO, folder_ / "out");
  redirect(STDERR_FILENO, folder_ / "err");
  return true;
}

Command::Command(const std::vector<std::string>& arguments, const EditorCalls& editor) {
  if (fork_off()) call(arguments, editor);
}

Command::Command(const std::vector<std::string>& arguments, const fs::path& out) {
  if (!fork_off()) return;
  if (out.empty())
    close(STDOUT_FILENO);
  else
    redirect(STDOUT_FILENO, out);
  call(arguments, {});
}

Command::~Command() {
  if (process_ > 0) {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void Command::send(int signal) const { kill(process_, signal); }

bool Command::is_running() const {
  siginfo_t ended{};
  waitid(P_PID, static_cast<id_t>(process_), &ended, WEXITED | WNOHANG | WNOWAIT);
  return ended.si_pid == 0;
}

double Command::processor_seconds() const {
  clockid_t clock = 0;
  timespec time{};
  if (clock_getcpuclockid(process_, &clock) == 0) clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Ended Command::wait() {
  int status = 0;
  rusage usage{};
  wait4(process_, &status, 0, &usage);
  process_ = -1;
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), read_text(folder_ / "out"),
          read_text(folder_ / "err"), static_cast<double>(usage.ru_maxrss) / 1024};
}

Ended run(const std::vector<std::string>& arguments) { return Command(arguments).wait(); }

bool in_own_process(const std::function<void()>& action) {
  const pid_t process = fork();
  if (process == 0) {
    action();
    _exit(0);
  }
  int status = -1;
  return process > 0 && waitpid(process, &status, 0) == process && status == 0;
}

Ended interrupt(const std::vector<std::string>& arguments, int signal,
                const std::function<bool(const Command&)>& is_time,
                const std::function<void()>& clear) {
  constexpr int kMostTries = 10;
  for (int tries = 1;; ++tries) {
    Command command(arguments);
    while (command.is_running() && !is_time(command))
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    command.send(signal);
    Ended ended = command.wait();
    const bool was_quicker = ended.status == 0 || ended.status == 1;
    if (!was_quicker || tries == kMostTries) return ended;
    clear();
  }
}

TemporaryFolder::TemporaryFolder() : path_(new_folder()) {}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void write_scene(const std::string& file, const Problem& problem) {
  Scene scene;
  scene.folder = fs::path(file).parent_path();
  scene.triangles = problem.mesh.triangles();
  scene.rest = problem.mesh.rest();
  scene.energy = problem.energy;
  scene.handles = problem.handles;
  scene.parameters = problem.parameters;
  save_scene(scene, file);
}

void write_text(const std::string& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

std::string read_text(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return std::move(text).str();
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

}  // namespace foldless::test
