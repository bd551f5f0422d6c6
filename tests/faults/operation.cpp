// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/faults/operation.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <string_view>
#include <thread>

#include "core/files/atomic_file.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {

namespace fs = std::filesystem;

namespace {

/// In the new process: does not return.
[[noreturn]] void become(std::string program, const std::vector<std::string>& arguments,
                         const std::string& fault, const fs::path& folder,
                         const TemporaryFolder& notes) {
  if (!fault.empty()) {
    ::setenv("LD_PRELOAD", FOLDLESS_FAULTS_LIBRARY, 1);
    ::setenv("FOLDLESS_FAULT", fault.c_str(), 1);
    ::setenv("FOLDLESS_FAULT_IN", folder.c_str(), 1);
    ::setenv("FOLDLESS_FAULT_MARK", (notes / "mark").c_str(), 1);
  }
  ::unsetenv("DISPLAY");
  const int err = ::open((notes / "err").c_str(), O_CREAT | O_WRONLY, 0600);
  const int out = ::open("/dev/null", O_WRONLY);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(err, STDERR_FILENO);
  std::vector<char*> words;
  words.push_back(program.data());
  for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  ::execv(program.c_str(), words.data());
  ::_exit(127);
}

std::string_view wanted_faults() {
  const char* wanted = std::getenv("FOLDLESS_FAULTS");
  return wanted ? wanted : "";
}

}  // namespace

Faulted run_with_fault(const std::vector<std::string>& arguments, const std::string& fault,
                       const fs::path& folder) {
  return run_other_with_fault(FOLDLESS_PROGRAM, arguments, fault, folder);
}

Faulted run_other_with_fault(const std::string& program, const std::vector<std::string>& arguments,
                             const std::string& fault, const fs::path& folder) {
  const TemporaryFolder notes;
  const pid_t process = ::fork();
  if (process == 0) become(program, arguments, fault, folder, notes);
  int ended = 0;
  ::waitpid(process, &ended, 0);
  return {fs::exists(notes / "mark"), WIFEXITED(ended) ? WEXITSTATUS(ended) : -WTERMSIG(ended),
          read_file(notes / "err")};
}

bool wants_all_faults() { return wanted_faults() == "all" || wanted_faults() == "places"; }

std::string memory_fault(long n) {
  return (wanted_faults() == "places" ? "place:" : "new:") + std::to_string(n);
}

long next_of_many(long n) { return wants_all_faults() ? n + 1 : n + 1 + n / 4; }

FaultCounts::~FaultCounts() {
  for (const auto& [kind, count] : counts_)
    std::cout << "faults of " << kind << ": " << count.failed << " failed, " << count.last
              << " were the last\n";
}

int FaultCounts::all_failed() const {
  int sum = 0;
  for (const auto& [kind, count] : counts_) sum += count.failed;
  return sum;
}

int FaultCounts::all_last() const {
  int sum = 0;
  for (const auto& [kind, count] : counts_) sum += count.last;
  return sum;
}

void run_and_kill(const std::vector<std::string>& arguments, std::chrono::microseconds time) {
  const TemporaryFolder notes;
  const pid_t process = ::fork();
  if (process == 0) become(FOLDLESS_PROGRAM, arguments, "", {}, notes);
  std::this_thread::sleep_for(time);
  ::kill(process, SIGKILL);
  ::waitpid(process, nullptr, 0);
}

Files files_in(const fs::path& folder) {
  Files files;
  if (!fs::exists(folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files[fs::relative(entry.path(), folder).string()] = read_file(entry.path());
  return files;
}

void write_files(const fs::path& folder, const Files& files) {
  fs::remove_all(folder);
  fs::create_directories(folder);
  for (const auto& [name, bytes] : files) {
    fs::create_directories((folder / name).parent_path());
    write_file_atomically(folder / name, bytes);
  }
}

}  // namespace foldless::test
