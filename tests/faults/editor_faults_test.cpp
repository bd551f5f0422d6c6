// SPDX-License-Identifier: GPL-3.0-or-later
// The same of what the editor writes: a recorded session saves or exports, without a window, while
// a call fails or is the last. Every file is the old one or the new one, and the program is not
// ended by it.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/files/atomic_file.h"
#include "tests/faults/operation.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHeldSquare = R"({"version": 1, "energy": "arap",
 "mesh": {"vertices": [[0,0],[1,0],[1,1],[0,1],[0.5,0.5]],
          "triangles": [[0,1,4],[1,2,4],[2,3,4],[3,0,4]]},
 "handles": [{"vertex": 0, "target": [0,0], "id": 1}]})";

/// Lines of a session.
class Lines {
 public:
  void key(const std::string& name, bool with_control = false) {
    add(R"("key": ")" + name + (with_control ? R"(", "held": ["ctrl"])" : "\""));
    add(R"("key_up": ")" + name + "\"");
    if (with_control) add(R"("held": [])");
  }
  void type(const std::string& words) { add(R"("type": ")" + words + "\""); }
  const std::string& text() const { return text_; }

 private:
  void add(const std::string& what) {
    text_ += R"({"t": )" + std::to_string(0.1 * ++count_) + ", " + what + "}\n";
  }

  std::string text_;
  int count_ = 0;
};

class EditorOperation {
 public:
  explicit EditorOperation(const Lines& lines) {
    std::string text = R"({"session": 1, "size": [640, 400], "file": "OUT/scene.json"})"
                       "\n";
    text += lines.text();
    for (std::size_t at = 0; (at = text.find("OUT/", at)) != text.npos;)
      text.replace(at, 3, out().string());
    folder_.write("session.jsonl", text);
    old_["scene.json"] = kHeldSquare;
    begin();
    const Faulted ended = run("");
    EXPECT_EQ(ended.status, 0) << ended.err;
    new_ = lasting(files_in(out()));
    EXPECT_NE(new_, old_) << "the session writes nothing";
  }

  /// A fault has happened, and all is well.
  bool bears(const std::string& fault) {
    SCOPED_TRACE(fault);
    begin();
    const Faulted ended = run(fault);
    if (!ended.has_happened) return false;
    const bool is_killed = fault.ends_with(":kill");
    EXPECT_TRUE(is_killed ? ended.status < 0 : ended.status == 0 || ended.status == 2)
        << ended.status << ' ' << ended.err;
    EXPECT_LE(std::ranges::count(ended.err, '\n'), 1) << ended.err;
    expect_old_or_new(files_in(out()), is_killed || fault.starts_with("unlink"));
    if (!is_killed) return true;
    EXPECT_EQ(run("").status, 0) << "it can be done then";
    EXPECT_EQ(lasting(files_in(out())), new_) << "nothing hidden is left either";
    return true;
  }

 private:
  fs::path out() const { return folder_ / "out"; }
  void begin() const { write_files(out(), old_); }
  Faulted run(const std::string& fault) const {
    return run_with_fault(
        {"replay", folder_ / "session.jsonl", "--shots", (folder_ / "shots").string()}, fault,
        out());
  }

  /// A PDF tells when it was made.
  static Files lasting(Files files) {
    for (auto& [name, bytes] : files)
      if (name.ends_with(".pdf")) bytes = bytes.ends_with("%%EOF\n") ? "whole" : "cut short";
    return files;
  }

  void expect_old_or_new(const Files& files, bool may_be_left) const {
    for (const auto& [name, bytes] : lasting(files)) {
      if (name.starts_with('.')) {
        EXPECT_TRUE(may_be_left) << name << " is left";
        continue;
      }
      const bool is_old = old_.contains(name) && old_.at(name) == bytes;
      EXPECT_TRUE(is_old || (new_.contains(name) && new_.at(name) == bytes)) << name;
    }
    EXPECT_TRUE(files.contains("scene.json"));
  }

  TemporaryFolder folder_;
  Files old_, new_;
};

void expect_it_bears(const Lines& lines, const std::vector<std::string>& kinds) {
  EditorOperation operation(lines);
  FaultCounts counts;
  for (const std::string& kind : kinds) {
    int calls = 0;
    for (; operation.bears(kind + ':' + std::to_string(calls + 1)); ++calls) counts.failed(kind);
    for (int n = 1; n <= calls; ++n, counts.last(kind))
      EXPECT_TRUE(operation.bears(kind + ':' + std::to_string(n) + ":kill")) << "as many as before";
  }
  EXPECT_GE(counts.all_failed(), 1);
  EXPECT_GE(counts.all_last(), 1);
}

const std::vector<std::string> kKindsOfCalls{"open",       "write", "fsync",
                                             "syncfolder", "close", "rename"};

Lines export_as(const std::string& file) {
  Lines lines;
  lines.key("E", true);
  lines.key("Enter");
  lines.key("A", true);
  lines.type(file);
  lines.key("Enter");
  return lines;
}

TEST(EditorFaults, ASave) {
  Lines lines;
  lines.key("S", true);
  expect_it_bears(lines, kKindsOfCalls);
}

// A session with a dialog takes seconds: by default a full disk for the first.
TEST(EditorFaults, EveryExport) {
  const bool all = wants_all_faults();
  const std::vector<std::string> names{"a.png", "a.obj", "a.svg", "a.pdf", "a.off", "a.ply"};
  for (std::size_t i = 0; i < (all ? names.size() : 1); ++i) {
    SCOPED_TRACE(names[i]);
    expect_it_bears(export_as("OUT/" + names[i]),
                    all ? kKindsOfCalls : std::vector<std::string>{"write"});
  }
}

}  // namespace
}  // namespace foldless::test
