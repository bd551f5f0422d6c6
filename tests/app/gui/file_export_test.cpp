// SPDX-License-Identifier: GPL-3.0-or-later
// A file that is written while the window lives.
#include "app/gui/file_export.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "app/gui/background_exports.h"
#include "core/error.h"
#include "core/mesh/generate.h"
#include "tests/app/gui/headless_editor.h"

namespace foldless::test {
namespace {

class FileExports : public testing::Test {
 protected:
  ~FileExports() override { may_end_ = true; }

  Editor& editor() { return headless_.editor(); }
  /// Waits until it may end, or is cancelled.
  FileExport::Write slow_write() {
    return [this](const FileExport::IsCancelled& is_cancelled) {
      while (!is_cancelled && !may_end_) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      return !is_cancelled;
    };
  }
  bool ends() {
    return headless_.wait_until([this] {
      exports_.file.update(editor(), browser_);
      return !exports_.file.is_busy();
    });
  }
  std::string said() {
    const auto& log = editor().messages().log();
    return log.empty() ? "" : log.back().text;
  }

  std::atomic<bool> may_end_ = false;
  HeadlessEditor headless_{{800, 600}};
  FileBrowser browser_;
  BackgroundExports exports_;
};

TEST_F(FileExports, GoOnWhileTheWindowLivesAndSayWhenTheyAreDone) {
  exports_.file.start("/tmp/a.png", slow_write(), nullptr);
  exports_.file.update(editor(), browser_);
  EXPECT_TRUE(exports_.is_busy());
  EXPECT_THROW(exports_.file.start("/tmp/b.png", slow_write(), nullptr), Error);
  EXPECT_EQ(said(), "");
  may_end_ = true;
  ASSERT_TRUE(ends());
  EXPECT_EQ(said(), "Wrote /tmp/a.png");
}

TEST_F(FileExports, AreCancelled) {
  exports_.file.start("/tmp/a.png", slow_write(), nullptr);
  exports_.file.cancel();
  ASSERT_TRUE(ends());
  EXPECT_EQ(said(), "The export was cancelled; nothing was written.");
}

TEST_F(FileExports, ThatFailSayWhy) {
  const auto fail = [](const FileExport::IsCancelled&) -> bool {
    throw Error("The disk is full.");
  };
  exports_.file.start("/tmp/a.png", fail, nullptr);
  ASSERT_TRUE(ends());
  EXPECT_EQ(said(), "The disk is full.");
}

TEST_F(FileExports, ThatFailAskNobodyWhoWasAskedSomethingElseMeanwhile) {
  const auto fail = [](const FileExport::IsCancelled&) -> bool {
    throw Error("The disk is full.");
  };
  exports_.file.start("/tmp/a.png", fail, &browser_);
  browser_.ask(FileRequest());
  ASSERT_TRUE(ends());
  EXPECT_EQ(said(), "The disk is full.");
}

}  // namespace
}  // namespace foldless::test
