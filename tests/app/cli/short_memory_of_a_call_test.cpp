// SPDX-License-Identifier: GPL-3.0-or-later
// Memory that fails while the command line is read ends in one sentence, also in functions of a
// library that say that they throw nothing.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <thread>

#include "app/cli/command_line.h"
#include "tests/support/failing_allocation.h"

namespace foldless::test {
namespace {

/// Every second allocation: a name is compared with those of all subcommands.
constexpr long kStep = 2;
constexpr int kThereWereFewer = 77;

/// In a process of its own: does not return.
[[noreturn]] void call_with_failing(long n, int out) {
  ::dup2(out, STDERR_FILENO);
  const FailingAllocation failing(n);
  int status = 0;
  std::thread([&status] {  // the thread of the test is spared
    const char* const words[] = {"foldless", "check", "a name that no short string holds.obj"};
    status = run_command_line(3, words, {});
  })
      .join();
  ::_exit(failing.has_happened() ? status : kThereWereFewer);
}

TEST(ShortMemoryOfACall, IsOneSentence) {
  int failed = 0;
  for (long n = 1;; n += kStep) {
    int pipe[2];
    ASSERT_EQ(::pipe(pipe), 0);
    const pid_t process = ::fork();
    if (process == 0) call_with_failing(n, pipe[1]);
    ::close(pipe[1]);
    char said[400];
    const ssize_t length = ::read(pipe[0], said, sizeof said);
    ::close(pipe[0]);
    int ended = 0;
    ::waitpid(process, &ended, 0);
    if (WIFEXITED(ended) && WEXITSTATUS(ended) == kThereWereFewer) break;
    ASSERT_GT(length, 0);
    const std::string sentence(said, static_cast<std::size_t>(length));
    EXPECT_TRUE(WIFEXITED(ended)) << n << ": " << sentence;
    EXPECT_TRUE(sentence.starts_with("foldless: ") && sentence.ends_with('\n')) << sentence;
    EXPECT_EQ(std::ranges::count(sentence, '\n'), 1) << n << ": " << sentence;
    ++failed;
  }
  EXPECT_GT(failed, 50);
}

}  // namespace
}  // namespace foldless::test
