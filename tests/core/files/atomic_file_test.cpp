// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/atomic_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "core/files/small_file.h"
#include "tests/support/errors.h"
#include "tests/support/temporary_folder.h"

namespace foldless {
namespace {

namespace fs = std::filesystem;
using test::error_of;
using test::TemporaryFolder;

std::ptrdiff_t file_count(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

TEST(AtomicFile, ReadsBackEveryByte) {
  const TemporaryFolder folder;
  std::string bytes;
  for (int i = 0; i < 200000; ++i) bytes += static_cast<char>(i * 7);
  write_file_atomically(folder / "a.bin", bytes);
  EXPECT_EQ(read_file(folder / "a.bin"), bytes);
  EXPECT_EQ(file_count(folder.path()), 1);
}

TEST(AtomicFile, WritesPartsOneAfterTheOther) {
  const TemporaryFolder folder;
  const std::string_view parts[] = {"one ", "", "two"};
  write_file_atomically(folder / "a.txt", parts);
  EXPECT_EQ(read_file(folder / "a.txt"), "one two");
}

TEST(AtomicFile, ReplacesTheWholeFileAndKeepsItsPermissions) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("a.txt", "a long old text");
  ::chmod(file.c_str(), 0640);
  write_file_atomically(file, "new");
  EXPECT_EQ(read_file(file), "new");
  EXPECT_EQ(fs::status(file).permissions(), fs::perms(0640));
}

TEST(AtomicFile, FollowsASymbolicLink) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("a.txt", "old");
  fs::create_symlink("a.txt", folder / "link");
  write_file_atomically(folder / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(read_file(file), "new");
}

TEST(AtomicFile, WritesToADeviceWithoutReplacingIt) {
  write_file_atomically("/dev/null", "text");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(AtomicFile, NamesThePathWhenTheFolderIsMissing) {
  const TemporaryFolder folder;
  const fs::path file = folder / "no_such_folder/a.txt";
  const std::string error = error_of([&] { write_file_atomically(file, "text"); });
  EXPECT_TRUE(error.starts_with(file.string() + ": cannot be written: ")) << error;
}

TEST(AtomicFile, LeavesNoTemporaryWhenTheTargetIsAFolder) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "a");
  EXPECT_NE(error_of([&] { write_file_atomically(folder / "a", "text"); }), "");
  EXPECT_EQ(file_count(folder.path()), 1);
}

/// A hidden file as a process leaves it that is killed while it writes.
void leave_half(const fs::path& file, int number) {
  write_new_file(file.parent_path() / (staged_prefix(file) + "00000" + std::to_string(number)),
                 "half", file);
}

TEST(AtomicFile, RemovesWhatKilledWritersOfTheSameFileLeft) {
  const TemporaryFolder folder;
  for (int i = 0; i < 3; ++i) leave_half(folder / "a.txt", i);
  leave_half(folder / "b.txt", 0);
  write_file_atomically(folder / "a.txt", "new");
  EXPECT_EQ(read_file(folder / "a.txt"), "new");
  EXPECT_EQ(file_count(folder.path()), 2) << "that of the other file stays";
}

TEST(AtomicFile, LeavesWhatAWriterThatLivesWorksOn) {
  const TemporaryFolder folder;
  leave_half(folder / "a.txt", 0);
  const fs::path in_use = *fs::directory_iterator(folder.path());
  const int lock = ::open(in_use.c_str(), O_RDONLY);
  ASSERT_EQ(::flock(lock, LOCK_EX | LOCK_NB), 0);
  leave_half(folder / "a.txt", 1);
  write_file_atomically(folder / "a.txt", "new");
  EXPECT_EQ(read_file(in_use), "half");
  EXPECT_EQ(file_count(folder.path()), 2);
  ::close(lock);
}

TEST(AtomicFile, WritersOfOneFileDoNotDisturbEachOther) {
  const TemporaryFolder folder;
  {
    std::vector<std::jthread> writers;
    for (const char letter : {'a', 'b', 'c'})
      writers.emplace_back([&, letter] {
        for (int i = 0; i < 40; ++i)
          EXPECT_NO_THROW(write_file_atomically(folder / "a.txt", std::string(5000, letter)));
      });
  }
  const std::string bytes = read_file(folder / "a.txt");
  EXPECT_EQ(bytes, std::string(5000, bytes.front()));
  EXPECT_EQ(file_count(folder.path()), 1);
}

TEST(SmallFile, IsReadWhereItIsOneAndElseEmpty) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_small_file(folder.write("a.json", "{}")), "{}");
  EXPECT_EQ(read_small_file(folder / "absent.json"), "");
  EXPECT_EQ(read_small_file(folder.path()), "");
  EXPECT_EQ(read_small_file(folder.write("large.json", std::string((1 << 20) + 1, ' '))), "");
  const fs::path pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(read_small_file(pipe), "") << "and nobody is waited for";
}

TEST(AtomicFile, WritesUnderTheLongestNameThatAFileCanHave) {
  const TemporaryFolder folder;
  const fs::path file = folder / std::string(255, 'a');
  write_file_atomically(file, "text");
  EXPECT_EQ(read_file(file), "text");
}

TEST(AtomicFile, GivesANewFileThePermissionsThatNewFilesGet) {
  const TemporaryFolder folder;
  const mode_t before = ::umask(027);
  write_file_atomically(folder / "a.txt", "text");
  ::umask(before);
  EXPECT_EQ(fs::status(folder / "a.txt").permissions(), fs::perms(0640));
}

TEST(AtomicFile, ReadsAPipeToWhichSomebodyWritesLateAndSlowly) {
  const TemporaryFolder folder;
  const fs::path pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] {
    const auto wait = [] { std::this_thread::sleep_for(std::chrono::milliseconds(60)); };
    wait();
    std::ofstream out(pipe);
    wait();
    out << "first " << std::flush;
    wait();
    out << "second";
  });
  EXPECT_EQ(read_file(pipe), "first second");
  writer.join();
}

TEST(AtomicFile, DoesNotWaitForEverForAWriterOfAPipe) {
  const TemporaryFolder folder;
  const fs::path pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(error_of([&] { read_file(pipe); }),
            pipe.string() + ": is a pipe that nobody writes to; begin the program that does");
}

TEST(AtomicFile, ReadsNoFileWithoutBound) {
  const std::string error = error_of([] { read_file("/dev/zero"); });
  EXPECT_EQ(error, "/dev/zero: has more than 1073741824 bytes, the most that is read");
}

TEST(AtomicFile, NamesThePathOfAFileThatCannotBeRead) {
  const TemporaryFolder folder;
  for (const fs::path& file : {folder / "missing", folder.path()}) {
    const std::string error = error_of([&] { read_file(file); });
    EXPECT_TRUE(error.starts_with(file.string() + ": cannot be read: ")) << error;
  }
}

}  // namespace
}  // namespace foldless
