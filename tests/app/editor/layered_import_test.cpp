// SPDX-License-Identifier: GPL-3.0-or-later
// Paintings of several layers in the editor: as parts, saved, and painted on elsewhere.
#include <gtest/gtest.h>

#include "app/editor/document_files.h"
#include "app/editor/picking.h"
#include "tests/app/editor/editor_fixture.h"
#include "tests/support/layered_files.h"

namespace foldless::test {
namespace {

class LayeredImport : public EditorTest {
 protected:
  LayeredImport() { write(doll()); }

  std::filesystem::path file() const { return folder_.path() / "doll.ora"; }
  void write(const LayeredImage& painting) const { folder_.write("doll.ora", ora_of(painting)); }
  ImageImport& import() { return editor_->files().image_import(); }
  const TextureImage& texture() const { return editor_->files().texture_image(); }
  void open() {
    editor_->files().open(file());
    wait_for([&] { return import().is_ready(); });
  }
  void take() {
    open();
    editor_->files().take_image();
  }
  /// The part that a click at a point of the painting takes, y up.
  std::string part_at(const Vec2& point) {
    const auto hit = pick_mesh(editor_->shown().get(), editor_->canvas(), pixel_of(point),
                               editor_->draft().paint_order());
    if (!hit) return "";
    const Snapshot& shown = *editor_->shown();
    const MeshParts& parts = *editor_->document().parts;
    const std::vector<int> of_triangle =
        parts_of_triangles(*shown.triangles, static_cast<int>(shown.rest->cols()), parts);
    return parts[static_cast<std::size_t>(of_triangle[static_cast<std::size_t>(hit->triangle)])]
        .layer;
  }
  /// Waits longer than files are left alone between two looks.
  void look_again() {
    now_ += 2;
    frame();
  }
  std::string last_toast() const {
    return editor_->messages().log().empty() ? "" : editor_->messages().log().back().text;
  }
  /// The level of red in the middle of a part's texture.
  int red_of(std::size_t part) const {
    const Image& image = texture().image()->at(part).levels->front();
    return image.at(image.width / 2, image.height / 2)[0];
  }

  TemporaryFolder folder_;
};

TEST_F(LayeredImport, MakesAPartOfEveryLayer) {
  open();
  EXPECT_TRUE(import().image()->has_layers());
  EXPECT_TRUE(import().is_by_layer());
  EXPECT_EQ(import().mesh()->mesh.parts, 4);
  editor_->files().take_image();
  const Document& document = editor_->document();
  ASSERT_NE(document.parts, nullptr);
  ASSERT_EQ(document.parts->size(), 4U);
  EXPECT_EQ(document.parts->front().layer, "Body");
  ASSERT_NE(texture().image(), nullptr) << "it was read already";
  EXPECT_EQ(texture().image()->size(), 4U);
  EXPECT_TRUE(is_valid());
}

TEST_F(LayeredImport, OnePictureIsAChoice) {
  open();
  import().set_by_layer(false);
  wait_for([&] { return import().is_ready(); });
  EXPECT_EQ(import().mesh()->mesh.parts, 1);
  import().set_by_layer(true);
  wait_for([&] { return import().is_ready(); });
  EXPECT_EQ(import().mesh()->mesh.parts, 4);
  import().set_by_layer(false);
  editor_->files().take_image();
  wait_for([&] { return !import().is_open(); });
  EXPECT_EQ(editor_->document().parts, nullptr);
  EXPECT_EQ(texture().image()->size(), 1U);
}

TEST_F(LayeredImport, AClickTakesTheFrontPart) {
  take();
  editor_->view().fit_all();
  EXPECT_EQ(part_at({58, 108}), "Left arm") << "over the body";
  EXPECT_EQ(part_at({102, 108}), "Right arm");
  EXPECT_EQ(part_at({80, 40}), "Body");
  EXPECT_EQ(part_at({80, 160}), "Head");
  place(editor_->document().parts->front().first_vertex);
  for (const auto& [depth, front] : {std::pair{1.5, "Left arm"}, std::pair{2.5, "Body"}}) {
    editor_->edits().change_selected("Depth", Change::appearance,
                                     [depth = depth](Handle& handle) { handle.depth = depth; });
    EXPECT_EQ(part_at({58, 108}), front) << "the arms' depths are 2 and 3";
  }
}

TEST_F(LayeredImport, SavingAndUndoKeepTheParts) {
  take();
  const auto parts = editor_->document().parts;
  place(parts->back().first_vertex);
  editor_->draft().undo();
  EXPECT_EQ(editor_->document().parts, parts);
  editor_->draft().redo();
  ASSERT_TRUE(editor_->files().save_as(folder_ / "doll.json"));
  const Document saved = editor_->document();
  editor_->files().new_document();
  EXPECT_EQ(editor_->document().parts, nullptr);
  editor_->files().open(folder_ / "doll.json");
  ASSERT_NE(editor_->document().parts, nullptr);
  EXPECT_TRUE(is_same_content(editor_->document(), saved));
  wait_for([&] { return texture().image() != nullptr; });
  EXPECT_EQ(texture().image()->size(), 4U);
  Document other = saved;
  other.parts = nullptr;
  EXPECT_FALSE(is_same_content(other, saved)) << "it would be another file";
}

TEST_F(LayeredImport, ANewPaintingIsReadAgainAndThePoseStays) {
  take();
  place(editor_->document().parts->back().first_vertex);
  const Vec2 from = pixel_of_handle(0);
  drag(from, from + Vec2(20, -30));
  settle();
  const Document posed = editor_->document();
  const auto before = texture().image();
  look_again();
  EXPECT_EQ(texture().image(), before) << "the file is as it was";
  LayeredImage painting = doll();
  painting.layers[0].image = plain(160, 200, {77, 0, 0, 255});
  write(painting);
  look_again();
  EXPECT_FALSE(texture().is_reading()) << "the old picture stays in sight";
  wait_for([&] { return texture().image() != before; });
  EXPECT_EQ(red_of(0), 77);
  EXPECT_EQ(last_toast(), "Read doll.ora again");
  EXPECT_TRUE(is_same_content(editor_->document(), posed));
}

TEST_F(LayeredImport, AChangeWhileTheDialogIsOpenIsNotMissed) {
  open();
  LayeredImage painting = doll();
  painting.layers[0].image = plain(160, 200, {78, 0, 0, 255});
  write(painting);
  editor_->files().take_image();
  look_again();
  wait_for([&] { return red_of(0) == 78; });
}

TEST_F(LayeredImport, AFileThatCannotBeReadAgainLeavesThePicture) {
  take();
  const auto before = texture().image();
  folder_.write("doll.ora", "half of it");
  look_again();
  wait_for([&] { return !texture().problem().empty(); });
  EXPECT_EQ(texture().image(), before);
  EXPECT_NE(last_toast().find("doll.ora: is not"), std::string::npos) << last_toast();
  std::filesystem::remove(file());
  const std::size_t messages = editor_->messages().log().size();
  look_again();
  EXPECT_EQ(editor_->messages().log().size(), messages) << "a moment between two files";
  LayeredImage painting = doll();
  painting.layers.pop_back();
  write(painting);
  look_again();
  wait_for([&] { return texture().image() != before; });
  bool is_told = false;
  for (const LoggedMessage& message : editor_->messages().log())
    is_told |= message.text == "doll.ora has no layer 'Right arm' any more: its part is not seen";
  EXPECT_TRUE(is_told);
}

TEST_F(LayeredImport, ReloadReadsInAnyCase) {
  take();
  const auto before = texture().image();
  editor_->files().reload_texture();
  wait_for([&] { return texture().image() != before; });
  EXPECT_EQ(texture().image()->size(), 4U);
}

}  // namespace
}  // namespace foldless::test
