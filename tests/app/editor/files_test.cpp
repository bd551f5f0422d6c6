// SPDX-License-Identifier: GPL-3.0-or-later
#include <fstream>
#include <iterator>

#include "app/editor/recent_files.h"
#include "tests/app/editor/editor_fixture.h"

namespace foldless::test {
namespace {

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void write(const std::filesystem::path& file, std::string_view text) {
  std::ofstream(file, std::ios::binary) << text;
}

class Files : public EditorTest {
 protected:
  Files() {
    make_editor({.state_folder = folder_.path() / "state", .wake = {}});
    open_grid(6);
  }

  std::filesystem::path file(std::string_view name) const { return folder_.path() / name; }
  std::string last_toast() const {
    return editor_->messages().toasts().empty() ? std::string()
                                                : editor_->messages().toasts().back().text;
  }
  bool has_request(Request request) {
    const auto requests = editor_->messages().take_requests();
    return std::find(requests.begin(), requests.end(), request) != requests.end();
  }

  TemporaryFolder folder_;
};

TEST_F(Files, ReopenExactlyWhereTheUserLeft) {
  place(0);
  click(pixel_of(Vec2(1.7, 3.4)));
  const int id = place(35);
  const Vec2 from = pixel_of_handle(id);
  drag(from, from + Vec2(-120, 90));
  settle();
  editor_->view().set_camera({{1.25, 3.5}, 77});
  editor_->view().options().layers.heat = true;
  editor_->view().options().checker_squares = 9;
  ASSERT_TRUE(editor_->files().save_as(file("scene.json"))) << last_toast();
  const Document saved = editor_->document();

  make_editor({});
  editor_->files().open(file("scene.json"));
  EXPECT_TRUE(is_same_content(editor_->document(), saved)) << last_toast();
  EXPECT_EQ(editor_->canvas().camera, (Camera{{1.25, 3.5}, 77}));
  EXPECT_TRUE(editor_->view().options().layers.heat);
  EXPECT_EQ(editor_->view().options().checker_squares, 9);
  EXPECT_FALSE(editor_->files().is_dirty());
  for (int k = 0; k < 5; ++k) frame();
  EXPECT_TRUE(is_same_content(editor_->document(), saved)) << "nothing runs after opening";
  EXPECT_EQ(editor_->status().kind, StatusKind::converged);
  ASSERT_TRUE(editor_->files().save_as(file("again.json")));
  EXPECT_EQ(bytes_of(file("scene.json")), bytes_of(file("again.json")));
}

TEST_F(Files, PlainSceneIsSolvedWhenItIsOpened) {
  write(file("plain.json"),
        R"({"mesh": {"vertices": [[0,0],[1,0],[1,1],[0,1]], "triangles": [[0,1,2],[0,2,3]]},
            "energy": "arap",
            "handles": [{"vertex": 0, "target": [0,0]}, {"vertex": 2, "target": [1.5,1.25]}]})");
  editor_->files().open(file("plain.json"));
  ASSERT_EQ(editor_->document().handles.size(), 2U) << last_toast();
  settle();
  EXPECT_EQ(editor_->status().kind, StatusKind::converged);
  EXPECT_FALSE(editor_->files().is_dirty()) << "the file leads there by itself";
}

TEST_F(Files, BadFilesAreOneToastAndLoseNothing) {
  place(0);
  const Document before = editor_->document();
  write(file("bad.json"), "{\"mesh\": \"nowhere.obj\", ");
  write(file("bad.obj"), "v 0 0 0\nv 1 0 0\nf 1 2 3\n");
  for (const auto* name : {"bad.json", "bad.obj", "missing.json", "missing.obj", "folder.x"}) {
    editor_->files().open(file(name));
    editor_->files().answer(Answer::discard);
    ASSERT_FALSE(editor_->messages().toasts().empty()) << name;
    EXPECT_EQ(editor_->messages().toasts().back().kind, ToastKind::error);
    EXPECT_NE(last_toast().find(name), std::string::npos) << last_toast();
    EXPECT_TRUE(is_same_content(editor_->document(), before));
  }
}

TEST_F(Files, ToastsGoAway) {
  editor_->messages().toast(ToastKind::notice, "Hello");
  const auto wake = editor_->next_wake();
  ASSERT_TRUE(wake.has_value());
  EXPECT_TRUE(editor_->update(*wake));
  EXPECT_TRUE(editor_->messages().toasts().empty());
}

TEST_F(Files, DirtyUntilSavedAndAgainAfterUndo) {
  EXPECT_FALSE(editor_->files().is_dirty());
  place(0);
  EXPECT_TRUE(editor_->files().is_dirty());
  EXPECT_TRUE(editor_->files().title().starts_with("\u25cf ")) << editor_->files().title();
  settle();
  editor_->files().save_as(file("scene"));
  EXPECT_EQ(editor_->files().path(), file("scene.json"));
  EXPECT_FALSE(editor_->files().is_dirty());
  EXPECT_EQ(editor_->files().title(), "scene.json");
  key(Key::z, kControl);
  EXPECT_TRUE(editor_->files().is_dirty());
  key(Key::y, kControl);
  EXPECT_FALSE(editor_->files().is_dirty());
}

TEST_F(Files, SaveAsksForAPathOnceOnly) {
  place(0);
  key(Key::s, kControl);
  EXPECT_TRUE(has_request(Request::save_dialog));
  editor_->files().save_as(file("scene.json"));
  place(35);
  key(Key::s, kControl);
  EXPECT_FALSE(has_request(Request::save_dialog));
  EXPECT_FALSE(editor_->files().is_dirty());
}

TEST_F(Files, UnsavedChangesAreAskedAboutBeforeClosing) {
  place(0);
  editor_->files().close();
  ASSERT_NE(editor_->files().question(), nullptr);
  EXPECT_EQ(editor_->files().question()->kind, PendingKind::close);
  editor_->files().answer(Answer::cancel);
  EXPECT_EQ(editor_->files().question(), nullptr);
  EXPECT_FALSE(has_request(Request::quit));

  editor_->files().close();
  editor_->files().answer(Answer::save);
  EXPECT_TRUE(has_request(Request::save_dialog));
  EXPECT_FALSE(has_request(Request::quit));
  editor_->files().save_as(file("scene.json"));
  EXPECT_TRUE(has_request(Request::quit));
}

TEST_F(Files, DiscardGoesOnAndNothingUnsavedIsNotAskedAbout) {
  place(0);
  editor_->files().new_document();
  ASSERT_NE(editor_->files().question(), nullptr);
  editor_->files().answer(Answer::discard);
  EXPECT_TRUE(editor_->document().is_empty());
  EXPECT_EQ(editor_->shown(), nullptr);
  editor_->files().close();
  EXPECT_EQ(editor_->files().question(), nullptr);
  EXPECT_TRUE(has_request(Request::quit));
}

TEST_F(Files, FailedSaveKeepsTheDocumentUnsaved) {
  place(0);
  write(file("blocker"), "a file, not a folder");
  EXPECT_FALSE(editor_->files().save_as(file("blocker") / "scene.json"));
  EXPECT_EQ(editor_->messages().toasts().back().kind, ToastKind::error);
  EXPECT_TRUE(editor_->files().is_dirty());
  EXPECT_TRUE(editor_->files().path().empty());
}

TEST_F(Files, DroppedImageIsTheTextureOfThePresentMesh) {
  write(file("cat.png"), "pixels");
  editor_->receive(FilesDropped{{file("cat.png")}}, now_);
  EXPECT_EQ(editor_->document().texture, file("cat.png"));
  EXPECT_EQ(editor_->document().original->rest.cols(), 36);
  key(Key::z, kControl);
  EXPECT_TRUE(editor_->document().texture.empty());
  editor_->receive(FilesDropped{{file("dog.png")}}, now_);
  EXPECT_TRUE(editor_->document().texture.empty());
  EXPECT_NE(last_toast().find("dog.png"), std::string::npos);
}

TEST_F(Files, DroppedMeshOpens) {
  write(file("triangle.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  editor_->receive(FilesDropped{{file("triangle.obj")}}, now_);
  EXPECT_EQ(editor_->document().original->triangles.cols(), 1) << last_toast();
  EXPECT_EQ(editor_->files().title(), "triangle");
  EXPECT_FALSE(editor_->files().is_dirty());
}

TEST_F(Files, AMeshAndAnImageThatAreDroppedTogetherAreOneDocument) {
  write(file("cat.png"), "pixels");
  write(file("triangle.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  editor_->receive(FilesDropped{{file("cat.png"), file("triangle.obj")}}, now_);
  EXPECT_EQ(editor_->document().original->triangles.cols(), 1) << last_toast();
  EXPECT_EQ(editor_->document().texture, file("cat.png"));
  EXPECT_TRUE(editor_->messages().toasts().empty()) << last_toast();
}

TEST_F(Files, OfManyThatAreDroppedOneIsOpenedAndTheRestIsSaid) {
  for (const char* name : {"first.obj", "second.obj", "third.obj"})
    write(file(name), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  editor_->receive(FilesDropped{{file("first.obj"), file("second.obj"), file("third.obj")}}, now_);
  EXPECT_EQ(editor_->files().title(), "first");
  EXPECT_NE(last_toast().find("2 of the files were left out"), std::string::npos) << last_toast();
  editor_->receive(FilesDropped{}, now_);
  EXPECT_EQ(editor_->files().title(), "first");
}

TEST_F(Files, TheTextureOfADropWaitsForTheQuestionToo) {
  write(file("cat.png"), "pixels");
  write(file("triangle.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  place(0);
  editor_->receive(FilesDropped{{file("triangle.obj"), file("cat.png")}}, now_);
  ASSERT_TRUE(editor_->files().question());
  EXPECT_TRUE(editor_->document().texture.empty());
  editor_->files().answer(Answer::discard);
  EXPECT_EQ(editor_->document().texture, file("cat.png"));
  EXPECT_EQ(editor_->files().title(), "\u25cf triangle");
}

TEST_F(Files, SamplesAreCopiesThatAreSavedElsewhere) {
  place(0);
  ASSERT_TRUE(editor_->files().save_as(file("sample.json")));
  editor_->files().open_sample(file("sample.json"));
  EXPECT_EQ(editor_->document().handles.size(), 1U) << last_toast();
  EXPECT_TRUE(editor_->files().path().empty());
  EXPECT_FALSE(editor_->files().is_dirty());
  editor_->files().save();
  EXPECT_TRUE(has_request(Request::save_dialog));
}

TEST_F(Files, SliderMovedAfterSavingIsUnsaved) {
  const ParameterRow& alpha = *find_parameter_row("alpha");
  editor_->edits().set_parameter(alpha, 1e6);
  ASSERT_TRUE(editor_->files().save_as(file("scene.json")));
  editor_->edits().set_parameter(alpha, 2e6);
  EXPECT_TRUE(editor_->files().is_dirty());
}

TEST_F(Files, TextureIsFoundAgainFromTheScenesFolder) {
  std::filesystem::create_directories(file("a/images"));
  write(file("a/images/cat.png"), "pixels");
  editor_->files().set_texture(file("a/images/cat.png"));
  ASSERT_TRUE(editor_->files().save_as(file("a/scene.json")));
  std::filesystem::rename(file("a"), file("b"));
  editor_->files().open(file("b/scene.json"));
  EXPECT_EQ(editor_->document().texture, file("b/images/cat.png")) << last_toast();
}

TEST(RecentFiles, TenNewestFirstAndKeptOnDisk) {
  const TemporaryFolder folder;
  const std::filesystem::path list = folder.path() / "state" / "recent.json";
  RecentFiles recent(list);
  for (int k = 0; k < 12; ++k) recent.add("/meshes/" + std::to_string(k) + ".obj");
  recent.add("/meshes/5.obj");
  const RecentFiles again(list);
  ASSERT_EQ(again.paths().size(), 10U);
  EXPECT_EQ(again.paths()[0], "/meshes/5.obj");
  EXPECT_EQ(again.paths()[1], "/meshes/11.obj");
  EXPECT_EQ(again.paths(), recent.paths());
}

TEST(RecentFiles, DamagedListIsEmpty) {
  const TemporaryFolder folder;
  write(folder.path() / "recent.json", "[\"/a.obj\", ");
  EXPECT_TRUE(RecentFiles(folder.path() / "recent.json").paths().empty());
  write(folder.path() / "recent.json", "{\"a\": 1}");
  EXPECT_TRUE(RecentFiles(folder.path() / "recent.json").paths().empty());
}

}  // namespace
}  // namespace foldless::test
