// SPDX-License-Identifier: GPL-3.0-or-later
// The same of what the editor does with a document: it opens it, keeps copies of unsaved work, and
// recovers that. What was open stays open, and what was kept is found again, the one from before or
// the newer one.
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <thread>

#include "app/editor/editor.h"
#include "app/editor/handle_edits.h"
#include "core/exception_words.h"
#include "core/files/atomic_file.h"
#include "tests/faults/operation.h"
#include "tests/support/patience.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFolder = "FOLDLESS_FAULTS_FOLDER";  // set for the program that has the fault
constexpr int kFailed = 2;

/// A square whose handle has that name.
std::string square(const std::string& name) {
  return R"({"version": 1, "energy": "arap",
 "mesh": {"vertices": [[0,0],[1,0],[1,1],[0,1],[0.5,0.5]],
          "triangles": [[0,1,4],[1,2,4],[2,3,4],[3,0,4]]},
 "handles": [{"vertex": 0, "target": [0,0], "id": 1, "name": ")" +
         name + R"("}]})";
}

EditorOptions options_in(const fs::path& folder) {
  return {.state_folder = folder / "state", .wake = {}};
}

std::string name_in(const Editor& editor) {
  return editor.document().handles.empty() ? "" : editor.document().handles.front().name;
}

void set_name_to(Editor& editor, const std::string& name) {
  editor.selection().select({1});
  set_name(editor, name);
}

/// What the work that a program left is called; empty where there is none.
std::string recovered_in(Editor& editor) {
  Recovery& recovery = editor.files().recovery();
  recovery.find();
  if (!recovery.is_open()) return "";
  comes_true([&] {
    editor.files().update();
    return recovery.work() || !recovery.problem().empty();
  });
  if (!recovery.work()) return "";
  editor.files().recover();
  return name_in(editor);
}

std::string what_is_kept(const fs::path& folder) {
  Editor editor(options_in(folder));
  return recovered_in(editor);
}

// What the program with the fault does; the fault counts from signal() on.

void open_another(Editor& editor, const fs::path& folder) {
  editor.files().open(folder / "earlier.json");
  std::signal(SIGUSR1, SIG_IGN);
  editor.files().open(folder / "newer.json");
  if (name_in(editor) == "newer") return;
  if (name_in(editor) != "earlier" || editor.messages().toasts().empty()) std::abort();
  throw std::runtime_error(editor.messages().toasts().back().text);
}

void keep_again(Editor& editor, const fs::path& folder) {
  editor.files().open(folder / "earlier.json");
  set_name_to(editor, "kept");
  editor.files().rescue();
  std::signal(SIGUSR1, SIG_IGN);
  set_name_to(editor, "newer");
  editor.files().rescue();
  const std::string problem = editor.files().autosave().take_problem();
  if (!problem.empty()) throw std::runtime_error(problem);
}

void recover_and_save(Editor& editor, const fs::path& folder) {
  std::signal(SIGUSR1, SIG_IGN);
  if (recovered_in(editor).empty()) throw std::runtime_error(editor.files().recovery().problem());
  const std::string problem = editor.files().try_save_as(folder / "saved.json");
  if (!problem.empty()) throw std::runtime_error(problem);
}

/// Not a test, as the following: ends without leaving anything in order, as a program that is
/// killed.
[[noreturn]] void run_in_the_folder(void (*what)(Editor&, const fs::path&)) {
  const char* folder = std::getenv(kFolder);
  if (!folder) std::_Exit(0);
  auto* const editor = new Editor(options_in(folder));
  try {
    what(*editor, folder);
  } catch (const std::exception& error) {
    std::cerr << words_of_exception(error, folder) << std::endl;
    std::_Exit(kFailed);
  }
  std::_Exit(0);
}

TEST(DocumentFaultsProgram, DISABLED_Opens) { run_in_the_folder(open_another); }
TEST(DocumentFaultsProgram, DISABLED_Keeps) { run_in_the_folder(keep_again); }
TEST(DocumentFaultsProgram, DISABLED_Recovers) { run_in_the_folder(recover_and_save); }

class DocumentFaults : public testing::Test {
 protected:
  DocumentFaults() {
    ::setenv(kFolder, out().c_str(), 1);
    for (const char* variable : {"GTEST_TOTAL_SHARDS", "GTEST_SHARD_INDEX",
                                 "TEST_PREMATURE_EXIT_FILE", "XML_OUTPUT_FILE", "GTEST_OUTPUT"})
      ::unsetenv(variable);
    before_ = {{"earlier.json", square("earlier")}, {"newer.json", square("newer")}};
  }
  ~DocumentFaults() override { ::unsetenv(kFolder); }

  fs::path out() const { return folder_ / "out"; }

  Faulted run(const std::string& program, const std::string& fault) const {
    write_files(out(), before_);
    return run_other_with_fault("/proc/self/exe",
                                {"--gtest_filter=DocumentFaultsProgram.DISABLED_" + program,
                                 "--gtest_also_run_disabled_tests"},
                                fault, out());
  }

  /// `look` is called after every fault, and told whether the program says that it has done it.
  template <typename Look>
  void bears(const std::string& program, const Look& look) {
    FaultCounts counts;
    const bool all = wants_all_faults();
    const auto happens = [&](const std::string& fault) {
      SCOPED_TRACE(program + ' ' + fault);
      const Faulted ended = run(program, fault);
      if (!ended.has_happened) return false;
      const bool is_killed = fault.ends_with(":kill");
      EXPECT_TRUE(is_killed ? ended.status == -SIGKILL
                            : ended.status == 0 || ended.status == kFailed)
          << ended.status << ' ' << ended.err;
      EXPECT_LE(std::ranges::count(ended.err, '\n'), 1) << ended.err;
      EXPECT_EQ(ended.status == kFailed, !ended.err.empty()) << ended.err;
      look(ended.status == 0);
      return true;
    };
    for (const std::string kind :
         {"reopen", "read", "open", "write", "fsync", "syncfolder", "close", "rename", "mkdir"}) {
      for (int n = 1; happens(kind + ':' + std::to_string(n)); ++n) counts.failed(kind);
      for (int n = 1; happens(kind + ':' + std::to_string(n) + ":kill"); ++n) counts.last(kind);
    }
    for (long n = 1; happens("new:" + std::to_string(n)); n = all ? n + 1 : 2 * n + 1)
      counts.failed("new");
    EXPECT_GT(counts.all_failed(), 8);
    EXPECT_GT(counts.all_last(), 2);
  }

  TemporaryFolder folder_;
  Files before_;
};

TEST_F(DocumentFaults, WhereNothingFailsAllIsDone) {
  EXPECT_EQ(run("Opens", "").status, 0);
  EXPECT_EQ(run("Keeps", "").status, 0);
  EXPECT_EQ(what_is_kept(out()), "newer");
}

TEST_F(DocumentFaults, ADocumentThatCannotBeOpenedLeavesTheOneThatIsOpen) {
  bears("Opens", [&](bool) {
    for (const auto& [name, bytes] : before_) EXPECT_EQ(read_file(out() / name), bytes);
  });
}

TEST_F(DocumentFaults, ACopyThatCannotBeKeptLeavesTheOneBefore) {
  bears("Keeps", [&](bool is_done) {
    const std::string kept = what_is_kept(out());
    EXPECT_TRUE(kept == "newer" || (!is_done && kept == "kept")) << kept;
  });
}

TEST_F(DocumentFaults, WorkThatIsRecoveredIsKeptUntilItIsSaved) {
  ASSERT_EQ(run("Keeps", "").status, 0);
  before_ = files_in(out());
  bears("Recovers", [&](bool is_done) {
    const bool is_saved = fs::exists(out() / "saved.json");
    EXPECT_TRUE(is_saved || !is_done);
    if (is_saved) {
      EXPECT_NE(read_file(out() / "saved.json").find("newer"), std::string::npos);
    } else {
      EXPECT_EQ(what_is_kept(out()), "newer");
    }
  });
}

}  // namespace
}  // namespace foldless::test
