// SPDX-License-Identifier: GPL-3.0-or-later
// Two programs on one file: neither loses what the other has saved.
#include <algorithm>

#include "core/energy/densities.h"
#include "core/files/atomic_file.h"
#include "tests/app/editor/autosave_fixture.h"

namespace foldless::test {
namespace {

/// Two editors have a scene open, both with a change of their own, and the second has saved.
class SharedFile : public AutosaveTest {
 protected:
  SharedFile() {
    open_grid(6);
    EXPECT_TRUE(files().save_as(file()));
    other_ = std::make_unique<Editor>();
    other_->view().resize(800, 600, 1);
    other_->files().open(file());
    other_->edits().set_energy(*find_density("dirichlet"));
    place(0);
    settle();
  }

  fs::path file() const { return folder_ / "scene.json"; }
  DocumentFiles& files() { return editor_->files(); }
  /// Returns what it wrote.
  std::string save_in_the_other() {
    other_->files().save();
    EXPECT_FALSE(other_->files().is_dirty());
    return read_file(file());
  }
  static bool says_it_is_shared(const Editor& editor) {
    return std::ranges::any_of(editor.messages().log(), [](const LoggedMessage& message) {
      return message.text.find("scene.json is open in another Foldless too") != std::string::npos;
    });
  }
  bool has_request(Request request) {
    const auto requests = editor_->messages().take_requests();
    return std::ranges::find(requests, request) != requests.end();
  }

  std::unique_ptr<Editor> other_;
};

TEST_F(SharedFile, IsSavedWithoutAQuestionWhileNobodyElseWroteIt) {
  files().save();
  EXPECT_FALSE(files().is_asking());
  EXPECT_FALSE(files().is_dirty());
  place(35);
  settle();
  files().save();
  EXPECT_FALSE(files().is_asking());
  EXPECT_FALSE(files().is_dirty());
}

TEST_F(SharedFile, IsNotReplacedWithoutAQuestion) {
  const std::string theirs = save_in_the_other();
  files().save();
  EXPECT_TRUE(files().asks_to_overwrite());
  EXPECT_EQ(read_file(file()), theirs);
  files().answer_overwrite(OverwriteAnswer::cancel);
  EXPECT_FALSE(files().is_asking());
  EXPECT_TRUE(files().is_dirty());
  EXPECT_EQ(read_file(file()), theirs);

  files().save();
  files().answer_overwrite(OverwriteAnswer::save_as);
  EXPECT_TRUE(has_request(Request::save_dialog));
  EXPECT_TRUE(files().save_as(folder_ / "mine.json"));
  EXPECT_EQ(read_file(file()), theirs);
  files().save();
  EXPECT_FALSE(files().is_asking()) << "that file is ours alone";
}

TEST_F(SharedFile, IsOverwrittenWhereTheUserSaysSo) {
  const std::string theirs = save_in_the_other();
  files().save();
  files().answer_overwrite(OverwriteAnswer::overwrite);
  EXPECT_FALSE(files().is_dirty());
  EXPECT_NE(read_file(file()), theirs);
  other_->edits().set_energy(*find_density("arap"));
  other_->files().save();
  EXPECT_TRUE(other_->files().asks_to_overwrite()) << "now it is the other's turn to be asked";
}

TEST_F(SharedFile, IsAskedAboutBeforeTheProgramEndsToo) {
  save_in_the_other();
  files().close();
  files().answer(Answer::save);
  EXPECT_TRUE(files().asks_to_overwrite());
  files().answer_overwrite(OverwriteAnswer::cancel);
  EXPECT_FALSE(has_request(Request::quit));
  files().close();
  files().answer(Answer::save);
  files().answer_overwrite(OverwriteAnswer::overwrite);
  EXPECT_TRUE(has_request(Request::quit));
}

TEST_F(SharedFile, ThatWasRemovedIsWrittenAnew) {
  fs::remove(file());
  files().save();
  EXPECT_FALSE(files().is_asking());
  EXPECT_TRUE(fs::exists(file()));
}

TEST_F(SharedFile, IsSaidToBeOpenElsewhereAsLongAsItIs) {
  EXPECT_FALSE(says_it_is_shared(*editor_));
  EXPECT_TRUE(says_it_is_shared(*other_));
  editor_.reset();
  Editor third;
  third.files().open(file());
  EXPECT_TRUE(says_it_is_shared(third)) << "the second still has it";
  third.files().new_document();
  other_.reset();
  Editor fourth;
  fourth.files().open(file());
  EXPECT_FALSE(says_it_is_shared(fourth));
  fourth.files().open(file());
  EXPECT_FALSE(says_it_is_shared(fourth)) << "it was open here";
}

TEST_F(SharedFile, IsAskedAboutAfterARecoveryIfItWasSavedSince) {
  for (const bool is_saved_since : {false, true}) {
    pass(61);
    wait_for_copies(1);
    if (is_saved_since) save_in_the_other();
    start();
    find_lost_work();
    ASSERT_TRUE(files().recovery().is_open());
    files().recover();
    files().save();
    EXPECT_EQ(files().asks_to_overwrite(), is_saved_since);
    if (is_saved_since) return;
    other_->files().open(file());
    other_->files().answer(Answer::discard);
    other_->edits().set_energy(*find_density("dirichlet"));
    place(35);
    settle();
  }
}

}  // namespace
}  // namespace foldless::test
