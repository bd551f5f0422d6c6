// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/image_import.h"

#include <fstream>

#include "tests/app/editor/editor_fixture.h"
#include "tests/support/pictures.h"

namespace foldless::test {
namespace {

class ImportedImages : public EditorTest {
 protected:
  ImportedImages() { write_ring(ring(), 120); }

  std::filesystem::path ring() const { return folder_.path() / "ring.png"; }
  ImageImport& import() { return editor_->files().image_import(); }
  void open_ready(const std::filesystem::path& file) {
    editor_->files().open(file);
    wait_for([&] { return import().is_ready(); });
  }
  std::string last_toast() const {
    return editor_->messages().toasts().empty() ? std::string()
                                                : editor_->messages().toasts().back().text;
  }

  TemporaryFolder folder_;
};

TEST_F(ImportedImages, AnOpenedImageHasAMeshByGoodDefaults) {
  editor_->files().open(ring());
  EXPECT_TRUE(import().is_open());
  EXPECT_TRUE(import().is_busy());
  EXPECT_TRUE(editor_->document().is_empty()) << "until it is taken";
  wait_for([&] { return import().is_ready(); });
  const ImageMesh& mesh = import().mesh()->mesh;
  EXPECT_EQ(mesh.parts, 2);
  EXPECT_EQ(mesh.holes, 1);
  EXPECT_GT(mesh.shape.rest.cols(), 1000);
}

TEST_F(ImportedImages, TakingOneMakesADocumentThatShowsThePictureAlone) {
  open_ready(ring());
  const Points rest = import().mesh()->mesh.shape.rest;
  editor_->files().take_image();
  EXPECT_FALSE(import().is_open());
  const Document& document = editor_->document();
  EXPECT_EQ(document.original->rest, rest);
  EXPECT_EQ(document.texture, ring());
  EXPECT_EQ(document.texture_box, (TextureBox{{0, 0}, {120, 120}}));
  EXPECT_EQ(document.name, "ring");
  EXPECT_TRUE(is_valid());
  EXPECT_NE(editor_->files().texture_image().image(), nullptr) << "it was read already";
  const Layers& layers = editor_->view().options().layers;
  EXPECT_TRUE(layers.fill && layers.handles);
  EXPECT_FALSE(layers.wireframe || layers.boundary || layers.heat);
  EXPECT_FALSE(editor_->files().is_dirty());
  EXPECT_EQ(editor_->draft().history().steps().size(), 1U);
  EXPECT_EQ(editor_->files().recent().front(), ring());
}

TEST_F(ImportedImages, ItsMeshIsPosedAndSavedAsAny) {
  open_ready(ring());
  editor_->files().take_image();
  place(0);
  const int id = place(40);
  const Vec2 from = pixel_of_handle(id);
  drag(from, from + Vec2(30, 20));
  settle();
  EXPECT_EQ(editor_->status().kind, StatusKind::converged);
  EXPECT_TRUE(is_valid());
  ASSERT_TRUE(editor_->files().save_as(folder_.path() / "ring.json")) << last_toast();
  const Document saved = editor_->document();
  make_editor({});
  editor_->files().open(folder_.path() / "ring.json");
  EXPECT_TRUE(is_same_content(editor_->document(), saved)) << last_toast();
  wait_for([&] { return editor_->files().texture_image().image() != nullptr; });
  EXPECT_FALSE(editor_->view().is_mesh_shown()) << "as it was left";
}

TEST_F(ImportedImages, TabShowsAndHidesTheMesh) {
  open_ready(ring());
  editor_->files().take_image();
  key(Key::tab);
  EXPECT_TRUE(editor_->view().options().layers.wireframe &&
              editor_->view().options().layers.boundary);
  key(Key::tab);
  EXPECT_FALSE(editor_->view().options().layers.wireframe ||
               editor_->view().options().layers.boundary);
}

TEST_F(ImportedImages, AMeshThatIsOpenedAfterwardsIsSeen) {
  open_ready(ring());
  editor_->files().take_image();
  open_grid(4);
  EXPECT_TRUE(editor_->view().is_mesh_shown());
}

TEST_F(ImportedImages, LeavingLeavesEverythingAsItWas) {
  open_grid(4);
  place(5);
  const Document before = editor_->document();
  const Layers layers = editor_->view().options().layers;
  const std::size_t steps = editor_->draft().history().steps().size();
  editor_->files().open(ring());
  ASSERT_NE(editor_->files().question(), nullptr) << "there are unsaved changes";
  editor_->files().answer(Answer::discard);
  wait_for([&] { return import().is_ready(); });
  editor_->escape();
  EXPECT_FALSE(import().is_open());
  EXPECT_TRUE(is_same_content(editor_->document(), before));
  EXPECT_EQ(editor_->view().options().layers, layers);
  EXPECT_EQ(editor_->draft().history().steps().size(), steps);
  EXPECT_TRUE(editor_->files().is_dirty());
}

TEST_F(ImportedImages, ADroppedImageBecomesTheTextureOfAMeshOrElseADocument) {
  editor_->receive(FilesDropped{{ring()}}, now_);
  EXPECT_TRUE(import().is_open());
  editor_->files().close_import();
  open_grid(4);
  editor_->receive(FilesDropped{{ring()}}, now_);
  EXPECT_FALSE(import().is_open());
  EXPECT_EQ(editor_->document().texture, ring());
  wait_for([&] { return editor_->files().texture_image().image() != nullptr; });
  EXPECT_EQ(editor_->files().texture_image().image()->front().levels->front().width, 120);
}

TEST_F(ImportedImages, OtherOptionsMakeAnotherMeshAndTheNewestWin) {
  open_ready(ring());
  const auto medium = import().mesh();
  ImageMeshOptions options = import().options();
  for (const double edge : {1.0, 1.5, 2.0, 40.0}) {
    options.edge_length = edge;
    import().set_options(options);
    EXPECT_TRUE(import().is_busy());
  }
  wait_for([&] { return import().is_ready(); });
  EXPECT_NE(import().mesh(), medium);
  EXPECT_LT(import().mesh()->mesh.shape.rest.cols(), 300) << "of the last edge length";
  import().set_options(options);
  EXPECT_FALSE(import().is_busy()) << "nothing is new";
}

TEST_F(ImportedImages, TakenBeforeItIsReadyItIsTakenThen) {
  editor_->files().open(ring());
  editor_->files().take_image();
  EXPECT_TRUE(import().is_open());
  wait_for([&] { return !editor_->document().is_empty(); });
  EXPECT_EQ(editor_->document().name, "ring");
}

TEST_F(ImportedImages, AnotherFileReplacesTheOneThatIsRead) {
  write_ring(folder_.path() / "large.png", 900);
  editor_->files().open(folder_.path() / "large.png");
  editor_->files().open(ring());
  wait_for([&] { return import().is_ready(); });
  EXPECT_EQ(import().image()->alpha.width, 120);
}

TEST_F(ImportedImages, BadImagesAreOneToastAndChangeNothing) {
  open_grid(4);
  const Document before = editor_->document();
  std::ofstream(folder_.path() / "bad.png") << "pixels";
  for (const char* name : {"bad.png", "missing.png"}) {
    editor_->files().open(folder_.path() / name);
    wait_for([&] { return !import().is_open(); });
    EXPECT_NE(last_toast().find(name), std::string::npos) << last_toast();
    EXPECT_TRUE(is_same_content(editor_->document(), before));
  }
}

TEST_F(ImportedImages, OneThatCannotBeMeshedSaysWhyAndIsNotTaken) {
  save_png(folder_.path() / "clear.png", Image(30, 30));
  editor_->files().open(folder_.path() / "clear.png");
  wait_for([&] { return !import().is_busy(); });
  EXPECT_TRUE(import().is_open());
  EXPECT_NE(import().problem().find("transparent everywhere"), std::string::npos);
  editor_->files().take_image();
  frame();
  EXPECT_TRUE(editor_->document().is_empty());
}

TEST_F(ImportedImages, TheEditorMayEndWhileOneIsMeshed) {
  write_ring(folder_.path() / "large.png", 900);
  editor_->files().open(folder_.path() / "large.png");
  editor_.reset();
}

}  // namespace
}  // namespace foldless::test
