// SPDX-License-Identifier: GPL-3.0-or-later
// The same of what the editor does with a document: it opens it, keeps copies of unsaved work, and
// recovers that. What was open stays open; of what was kept the newest is found again, or, where a
// newer copy was being written, the one before.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>

#include "app/editor/editor.h"
#include "app/editor/handle_edits.h"
#include "core/exception_words.h"
#include "core/files/atomic_file.h"
#include "core/files/folder_names.h"
#include "tests/faults/operation.h"
#include "tests/support/patience.h"
#include "tests/support/pictures.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFolder = "FOLDLESS_FAULTS_FOLDER";  // set for the program that has the fault
constexpr int kFailed = 2;
constexpr double kLater = 100;  // when a change has its copy [s]

/// A square whose handle has that name.
std::string square(const std::string& name, const std::string& mesh, const std::string& more = "") {
  return R"({"version": 1, "energy": "arap", "mesh": )" + mesh + more +
         R"(, "handles": [{"vertex": 0, "target": [0,0], "id": 1, "name": ")" + name + R"("}]})";
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

void expect_done(const std::string& problem) {
  if (!problem.empty()) throw std::runtime_error(problem);
}

/// What went wrong by what the user was shown.
std::string error_shown(const Editor& editor) {
  for (const LoggedMessage& message : editor.messages().log())
    if (message.kind == ToastKind::error) return message.text;
  return "";
}

/// What the work that a program left is called; empty where there is none.
std::string recovered_in(Editor& editor) {
  Recovery& recovery = editor.files().recovery();
  recovery.find();
  editor.files().update();
  if (!recovery.is_open()) return "";
  comes_true([&] {
    editor.files().update();
    return recovery.work() || !recovery.problem().empty();
  });
  if (!recovery.work()) throw std::runtime_error(recovery.problem());
  editor.files().recover();
  return name_in(editor);
}

std::string what_is_kept(const fs::path& folder) {
  Editor editor(options_in(folder));
  return recovered_in(editor);
}

// What the program with the fault does; the fault counts from signal() on.

void open_another(const fs::path& folder) {
  Editor editor(options_in(folder));
  editor.files().open(folder / "earlier.json");
  std::signal(SIGUSR1, SIG_IGN);
  editor.files().open(folder / "newer.json");
  if (name_in(editor) == "newer")
    comes_true([&] {
      editor.files().update();
      return !editor.files().texture_image().is_reading();
    });
  const bool is_open = name_in(editor) == "newer";
  const std::string problem = error_shown(editor);
  if (!is_open && (name_in(editor) != "earlier" || problem.empty())) std::abort();
  // Where memory was short for what comes after it, it may have no file yet: then it is told, and
  // saving it asks for one.
  const fs::path path = editor.files().path();
  const bool has_its_file = path == folder / (is_open ? "newer.json" : "earlier.json");
  if (!has_its_file && (!is_open || !path.empty() || problem.empty())) std::abort();
  if (!is_open && editor.files().is_dirty()) std::abort();
  expect_done(problem);
  if (!editor.files().texture_image().image()) std::abort();
}

/// The program that is ended has five copies, so that the next makes the oldest go.
void keep_again(const fs::path& folder) {
  Editor editor(options_in(folder));
  editor.files().open(folder / "earlier.json");
  for (const char* name : {"1", "2", "3", "4", "kept"}) {
    set_name_to(editor, name);
    expect_done(editor.files().rescue());
  }
  const fs::path copies = folder / "state/autosave";
  const fs::path next = copies / names_in_folder(copies).at(0) / "000006.json";
  std::signal(SIGUSR1, SIG_IGN);
  set_name_to(editor, "newer");
  editor.update(0);
  comes_true([&] {
    editor.update(kLater);
    return fs::exists(next) || !error_shown(editor).empty();
  });
  expect_done(error_shown(editor));
}

void keep_at_the_end(const fs::path& folder) {
  Editor editor(options_in(folder));
  editor.files().open(folder / "earlier.json");
  set_name_to(editor, "newer");
  std::signal(SIGUSR1, SIG_IGN);
  expect_done(editor.files().rescue());
}

void recover_and_save(const fs::path& folder) {
  std::signal(SIGUSR1, SIG_IGN);
  Editor editor(options_in(folder));
  const std::string name = recovered_in(editor);
  const std::string problem = error_shown(editor);
  if (name != "newer" && problem.empty()) std::abort();
  if (!name.empty()) expect_done(editor.files().try_save_as(folder / "saved.json"));
  expect_done(problem);
}

/// As the program does.
[[noreturn]] void end_without_memory() {
  std::cerr << "there is not enough memory" << std::endl;
  std::_Exit(kFailed);
}

/// Not a test, as the following: ends at once with what went wrong.
void run_in_the_folder(void (*what)(const fs::path&)) {
  const char* folder = std::getenv(kFolder);
  if (!folder) GTEST_SKIP() << "is run by the tests below";
  std::set_terminate(end_without_memory);
  try {
    what(folder);
  } catch (const std::exception& error) {
    std::cerr << words_of_exception(error, folder) << std::endl;
    std::_Exit(kFailed);
  }
  std::_Exit(0);
}

TEST(DocumentFaultsProgram, DISABLED_Opens) { run_in_the_folder(open_another); }
TEST(DocumentFaultsProgram, DISABLED_Keeps) { run_in_the_folder(keep_again); }
TEST(DocumentFaultsProgram, DISABLED_KeepsAtTheEnd) { run_in_the_folder(keep_at_the_end); }
TEST(DocumentFaultsProgram, DISABLED_Recovers) { run_in_the_folder(recover_and_save); }

using Kinds = std::vector<std::string>;
const Kinds kAll{"list",  "reopen",     "read",  "lock",   "open",  "write",
                 "fsync", "syncfolder", "close", "rename", "mkdir", "unlink"};

/// Which faults there are by default, where each is a program that begins.
struct Wanted {
  Kinds fails, ends;
  long (*next)(long) = [](long n) { return 3 * n + 1; };  ///< the allocation after the n-th
};

class DocumentFaults : public testing::Test {
 protected:
  DocumentFaults() {
    ::setenv(kFolder, out().c_str(), 1);
    for (const char* variable : {"GTEST_TOTAL_SHARDS", "GTEST_SHARD_INDEX",
                                 "TEST_PREMATURE_EXIT_FILE", "XML_OUTPUT_FILE", "GTEST_OUTPUT"})
      ::unsetenv(variable);
    write_ring(folder_ / "ring.png", 4);
    const std::string inline_mesh =
        R"({"vertices": [[0,0],[1,0],[1,1],[0,1]], "triangles": [[0,1,2],[0,2,3]]})";
    before_ = {{"earlier.json", square("earlier", inline_mesh)},
               {"newer.json", square("newer", R"("mesh.obj")", R"(, "texture": "ring.png")")},
               {"mesh.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n"},
               {"ring.png", read_file(folder_ / "ring.png")}};
    given_ = before_;
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

  /// Whether the fault happens; `look` is called then, and told whether the program says that it
  /// has done it.
  template <typename Look>
  bool bears(const std::string& program, const std::string& fault, const Look& look) const {
    SCOPED_TRACE(program + ' ' + fault);
    const Faulted ended = run(program, fault);
    if (!ended.has_happened) return false;
    if (fault.ends_with(":kill"))
      EXPECT_EQ(ended.status, -SIGKILL);
    else
      EXPECT_TRUE(ended.status == 0 || ended.status == kFailed) << ended.status << ' ' << ended.err;
    EXPECT_LE(std::ranges::count(ended.err, '\n'), 1) << ended.err;
    EXPECT_EQ(ended.status == kFailed, !ended.err.empty()) << ended.err;
    for (const auto& [name, bytes] : given_) EXPECT_EQ(read_file(out() / name), bytes) << name;
    look(ended.status == 0);
    return true;
  }

  /// Every call of some kinds fails, and every call of some is the last.
  template <typename Look>
  void bears_all(const std::string& program, const Wanted& wanted, const Look& look) const {
    FaultCounts counts;
    const bool all = wants_all_faults();
    for (const std::string& kind : all ? kAll : wanted.fails)
      for (int n = 1; bears(program, kind + ':' + std::to_string(n), look); ++n)
        counts.failed(kind);
    for (const std::string& kind : all ? kAll : wanted.ends)
      for (int n = 1; bears(program, kind + ':' + std::to_string(n) + ":kill", look); ++n)
        counts.last(kind);
    for (long n = 1; bears(program, memory_fault(n), look);
         n = all ? next_of_many(n) : wanted.next(n))
      counts.failed("new");
    for (const std::string& kind : wanted.fails) EXPECT_TRUE(counts.has_failed(kind)) << kind;
    for (const std::string& kind : wanted.ends) EXPECT_TRUE(counts.has_been_last(kind)) << kind;
  }

  TemporaryFolder folder_;
  Files given_;   ///< of the user
  Files before_;  ///< with what a program has kept
};

TEST_F(DocumentFaults, WhereNothingFailsAllIsDone) {
  for (const char* program : {"Opens", "KeepsAtTheEnd", "Keeps"}) {
    const Faulted ended = run(program, "");
    EXPECT_EQ(ended.status, 0) << program << ' ' << ended.err;
  }
  EXPECT_EQ(what_is_kept(out()), "newer");
}

TEST_F(DocumentFaults, WhatCannotBeOpenedLeavesTheDocumentThatIsOpen) {
  bears_all("Opens", {{"reopen", "read"}, {}, [](long n) { return n + 14; }}, [](bool) {});
}

TEST_F(DocumentFaults, ACopyThatCannotBeKeptLeavesTheOneBefore) {
  bears_all("Keeps",
            {{"list", "open", "write", "fsync", "rename", "unlink"},
             {"open", "write", "rename", "unlink"}},
            [&](bool is_done) {
              const std::string kept = what_is_kept(out());
              EXPECT_TRUE(kept == "newer" || (!is_done && kept == "kept")) << kept;
            });
}

TEST_F(DocumentFaults, AFirstCopyIsKeptOrItIsSaid) {
  bears_all("KeepsAtTheEnd", {{"mkdir", "write", "rename"}, {"mkdir", "rename"}},
            [&](bool is_done) {
              const std::string kept = what_is_kept(out());
              EXPECT_TRUE(kept == "newer" || (!is_done && kept.empty())) << kept;
            });
}

TEST_F(DocumentFaults, WorkThatIsRecoveredIsKeptUntilItIsSaved) {
  ASSERT_EQ(run("Keeps", "").status, 0);
  before_ = files_in(out());
  bears_all("Recovers", {{"list", "reopen", "read", "rename"}, {"rename", "unlink"}},
            [&](bool is_done) {
              const fs::path saved = out() / "saved.json";
              const bool is_saved =
                  fs::exists(saved) && read_file(saved).find("newer") != std::string::npos;
              EXPECT_TRUE(is_saved || !is_done);
              const std::string kept = what_is_kept(out());
              EXPECT_TRUE(kept == "newer" || (is_saved && kept.empty())) << kept;
            });
}

}  // namespace
}  // namespace foldless::test
