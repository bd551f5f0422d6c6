// SPDX-License-Identifier: GPL-3.0-or-later
// Every call that writes is made to fail, one after the other, and so is memory; and the program is
// ended before every such call. The old files are there then, or the new ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

#include "core/files/atomic_file.h"
#include "tests/faults/operation.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kScene = FOLDLESS_ASSETS_DIR "/scenes/figure1_blocked_edge.json";
constexpr const char* kOther = FOLDLESS_ASSETS_DIR "/scenes/figure12_splits.json";
constexpr int kNotSatisfied = 1, kBadInput = 2;
constexpr const char* kFrom[] = {"foldless", "lim", "paper-flip"};  // methods of tables

bool is_hidden(const std::string& path) {
  return path.starts_with('.') || path.find("/.") != path.npos;
}

/// The methods that a text speaks of.
std::string methods_in(const std::string& text) {
  std::string names;
  for (const char* name : kFrom)
    if (text.find(name) != text.npos) names += std::string(name) + ' ';
  return names;
}

bool has_seconds(const std::string& name) {
  return name.ends_with(".csv") || name.ends_with("report.json") ||
         name.ends_with("manifest.json") || name.ends_with("results.json") ||
         name.ends_with(".md") || name.ends_with(".tex") || name.ends_with(".jsonl");
}

/// What of a result is the same whenever it is made: of what tells of seconds, the methods.
Files lasting(Files files) {
  for (auto& [name, bytes] : files)
    if (has_seconds(name)) bytes = methods_in(bytes);
  return files;
}

/// The state of a folder, whatever seconds files tell of.
Files without_seconds(Files files) {
  for (auto& [name, bytes] : files)
    if (has_seconds(name)) std::erase_if(bytes, [](char c) { return c >= '0' && c <= '9'; });
  return files;
}

Files without_hidden(Files files) {
  std::erase_if(files, [](const auto& file) { return is_hidden(file.first); });
  return files;
}

/// Something that the program does in a folder.
class Operation {
 public:
  /// Its result is on its way in the folder `committed` before all its files have their names.
  explicit Operation(std::vector<std::string> arguments,
                     std::string committed = ".foldless-committed/")
      : arguments_(std::move(arguments)), committed_(std::move(committed)) {
    fs::create_directory(folder());
  }

  /// What was there before; made by the program too, so that it may be replaced.
  void begin_with(const std::vector<std::string>& arguments) {
    EXPECT_LE(run(arguments, "").status, kNotSatisfied);
    old_ = files_in(folder());
  }
  void find_new() {
    EXPECT_LE(run(arguments_, "").status, kNotSatisfied);
    new_ = lasting(files_in(folder()));
    EXPECT_NE(new_, lasting(old_));
  }

  /// False when there are fewer such calls.
  bool fails_well(const std::string& fault) {
    SCOPED_TRACE(fault);
    write_files(folder(), old_);
    const Faulted ended = run(arguments_, fault);
    if (!ended.has_happened) return false;
    const Files files = files_in(folder());
    if (ended.status <= kNotSatisfied && ended.status >= 0) {
      EXPECT_FALSE(fault.starts_with("fsync:")) << "what it wrote may not be on the disk";
      EXPECT_EQ(lasting(without_hidden(files)), new_) << "it says that it has done it";
      return true;
    }
    EXPECT_EQ(ended.status, kBadInput) << ended.err;
    EXPECT_TRUE(ended.err.starts_with("foldless: ")) << ended.err;
    EXPECT_EQ(std::ranges::count(ended.err, '\n'), 1) << ended.err;
    expect_old_or_new(files);
    for (const auto& [name, bytes] : files)
      EXPECT_TRUE(!is_hidden(name) || name.starts_with(committed_) || fault.starts_with("unlink"))
          << name << " is left";
    return true;
  }

  bool dies_well(const std::string& fault) {
    SCOPED_TRACE(fault);
    write_files(folder(), old_);
    if (!run(arguments_, fault + ":kill").has_happened) return false;
    const Files files = files_in(folder());
    expect_old_or_new(files);
    if (!left_.insert(without_seconds(files)).second)
      return true;  // what the next call does with it is known
    EXPECT_LE(run(arguments_, "").status, kNotSatisfied) << "it can be done then";
    EXPECT_EQ(lasting(files_in(folder())), new_) << "nothing hidden is left either";
    return true;
  }

 private:
  Faulted run(std::vector<std::string> arguments, const std::string& fault) const {
    for (std::string& argument : arguments)
      if (argument.starts_with("OUT")) argument = folder().string() + argument.substr(3);
    return run_with_fault(arguments, fault, folder());
  }

  /// A result that has not taken all its names yet is whole with `.foldless-committed` before it.
  void expect_old_or_new(const Files& files) const {
    Files seen = without_hidden(files);
    for (const auto& [name, bytes] : files)
      if (name.starts_with(committed_) && !is_hidden(name.substr(committed_.size())) &&
          !name.starts_with(committed_ + "earlier"))
        seen[name.substr(committed_.size())] = bytes;
    if (seen == old_) return;
    seen = lasting(seen);
    if (files.contains(committed_ + "manifest.json"))  // files of the old result may still be there
      std::erase_if(seen, [&](const auto& file) { return !new_.contains(file.first); });
    EXPECT_EQ(seen, new_);
  }

  fs::path folder() const { return folder_ / "out"; }

  TemporaryFolder folder_;
  std::vector<std::string> arguments_;
  std::string committed_;
  Files old_, new_;
  std::set<Files> left_;  ///< by calls that were killed
};

constexpr const char* kKinds[] = {"open",  "write",  "fsync", "syncfolder",
                                  "close", "rename", "mkdir", "unlink"};
/// Of which there are many.
constexpr const char* kKindsThatRead[] = {"reopen", "read"};

void expect_it_bears_all(Operation& operation) {
  FaultCounts counts;
  const auto bear = [&](const std::string& kind, long (*next)(long)) {
    long n = 1;
    for (; operation.fails_well(kind + ':' + std::to_string(n)); n = next(n)) counts.failed(kind);
    const long end = n;
    for (n = 1; n < end; n = next(n), counts.last(kind))
      EXPECT_TRUE(operation.dies_well(kind + ':' + std::to_string(n))) << "as many calls as before";
  };
  for (const char* kind : kKinds) bear(kind, [](long n) { return n + 1; });
  for (const char* kind : kKindsThatRead) bear(kind, next_of_many);
  EXPECT_GT(counts.all_failed(), 3);
  EXPECT_GT(counts.all_last(), 3);
}

void expect_it_bears_little_memory(Operation& operation) {
  FaultCounts counts;
  for (long n = 1; operation.fails_well(memory_fault(n)); n = next_of_many(n)) counts.failed("new");
  EXPECT_GT(counts.all_failed(), 20);
}

TEST(Faults, ASolveOverAnotherResult) {
  Operation operation({"solve", kScene, "-o", "OUT"});
  operation.begin_with({"solve", kOther, "-o", "OUT"});
  operation.find_new();
  expect_it_bears_all(operation);
  expect_it_bears_little_memory(operation);
}

TEST(Faults, ASolveWithFramesOverAnotherResult) {
  Operation operation({"solve", kScene, "-o", "OUT", "--frames", "all"});
  operation.begin_with({"solve", kOther, "-o", "OUT", "--frames", "9"});
  operation.find_new();
  expect_it_bears_all(operation);
  expect_it_bears_little_memory(operation);
}

TEST(Faults, ABenchOverAnother) {
  Operation operation({"bench", kScene, "--method", "lim", "-o", "OUT"},
                      ".results.csv.foldless-committed/");
  operation.begin_with({"bench", kScene, "--method", "paper-flip", "-o", "OUT"});
  operation.find_new();
  expect_it_bears_all(operation);
  expect_it_bears_little_memory(operation);
}

TEST(Faults, ABenchThatAppends) {
  const std::vector<std::string> append{"bench",          kScene,     "--method",
                                        "lim,paper-flip", "--append", "OUT/a.jsonl"};
  Operation operation(append);
  std::vector<std::string> shard = append;
  shard.insert(shard.end(), {"--shard", "1/2"});
  operation.begin_with(shard);
  operation.find_new();
  expect_it_bears_all(operation);
  expect_it_bears_little_memory(operation);
}

TEST(Faults, AMeshOfAPicture) {
  const TemporaryFolder folder;
  const std::string picture = folder / "a.png";  // a small one: so there are few allocations
  ASSERT_EQ(
      run_with_fault({"render", kOther, "-o", picture, "--size", "32x24", "--transparent"}, "", "")
          .status,
      0);
  Operation operation({"mesh", picture, "-o", "OUT/a.json"});
  operation.begin_with({"mesh", picture, "-o", "OUT/a.json", "--edge-length", "4"});
  operation.find_new();
  expect_it_bears_all(operation);
  expect_it_bears_little_memory(operation);
}

TEST(Faults, AFigure) {
  Operation operation({"render", kScene, "-o", "OUT/a.svg"});
  operation.begin_with({"render", kOther, "-o", "OUT/a.svg"});
  operation.find_new();
  expect_it_bears_all(operation);
  expect_it_bears_little_memory(operation);
}

}  // namespace
}  // namespace foldless::test
