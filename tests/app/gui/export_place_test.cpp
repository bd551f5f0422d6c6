// SPDX-License-Identifier: GPL-3.0-or-later
// Where exports go: never over what the document is made of.
#include <gtest/gtest.h>
#include <imgui_internal.h>

#include "core/files/atomic_file.h"
#include "core/files/mesh_io.h"
#include "core/mesh/generate.h"
#include "tests/app/gui/headless_editor.h"
#include "tests/support/pictures.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

class ExportPlace : public testing::Test {
 protected:
  ExportPlace() { write_ring(drawing(), 300); }

  std::filesystem::path drawing() const { return folder_.path() / "ring.png"; }
  Editor& editor() { return headless_.editor(); }
  void open_drawing() {
    editor().files().open(drawing());
    ASSERT_TRUE(
        headless_.wait_until([this] { return editor().files().image_import().is_ready(); }));
    headless_.key(Key::enter);
    headless_.calm_down();
  }
  static bool asks_for_file() {
    const ImGuiWindow* browser = ImGui::FindWindowByName("##file browser");
    return browser && browser->WasActive;
  }
  /// Up to the field for the file's name.
  void ask_for_export() {
    headless_.key(Key::e, kControl);
    headless_.key(Key::enter);
    ASSERT_TRUE(asks_for_file());
  }
  void retype(const std::filesystem::path& file) {
    headless_.key(Key::a, kControl);
    headless_.type(file.string());
  }
  void enter_and_wait() {
    headless_.key(Key::enter);
    ASSERT_TRUE(headless_.wait_until([this] { return !headless_.ui().is_exporting(); }));
  }

  TemporaryFolder folder_;
  HeadlessEditor headless_{{1000, 640}};
};

TEST_F(ExportPlace, OfADrawingIsBesideItUnderAnotherName) {
  open_drawing();
  const std::string before = read_file(drawing());
  ask_for_export();
  enter_and_wait();
  EXPECT_EQ(read_file(drawing()), before);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "ring-posed.png"));
}

TEST_F(ExportPlace, OfAMeshIsBesideIt) {
  const Shape shape = bar(4, 1, 2);
  write_mesh(folder_ / "bar.obj", shape.triangles, shape.rest);
  editor().files().open(folder_ / "bar.obj");
  headless_.calm_down();
  ask_for_export();
  enter_and_wait();
  EXPECT_TRUE(std::filesystem::exists(folder_ / "bar.png"));
}

TEST_F(ExportPlace, ADrawingIsNotReplacedByWhatIsMadeOfIt) {
  open_drawing();
  const std::string before = read_file(drawing());
  std::filesystem::create_symlink(drawing(), folder_ / "link.png");
  for (const char* name : {"ring.png", "link.png"}) {
    ask_for_export();
    retype(folder_ / name);
    headless_.key(Key::enter);
    headless_.key(Key::r);
    EXPECT_EQ(read_file(drawing()), before) << name;
    EXPECT_TRUE(asks_for_file()) << name;
    retype(folder_ / (std::string("other-") + name));
    enter_and_wait();
    EXPECT_TRUE(std::filesystem::exists(folder_ / (std::string("other-") + name)));
  }
}

TEST_F(ExportPlace, NeitherASceneNorTheTextOfATableReplacesADrawing) {
  open_drawing();
  const std::string before = read_file(drawing());
  EXPECT_NE(editor().files().try_save_as(drawing()), "");
  EXPECT_EQ(read_file(drawing()), before);
  editor().messages().request(Request::export_csv);
  headless_.settle();
  retype(drawing());
  headless_.key(Key::enter);
  headless_.key(Key::r);
  EXPECT_EQ(read_file(drawing()), before);
}

TEST_F(ExportPlace, GoesWhereTheLastExportOfTheDocumentWent) {
  std::filesystem::create_directory(folder_ / "out");
  open_drawing();
  ask_for_export();
  retype(folder_ / "out" / "first.png");
  enter_and_wait();
  ask_for_export();
  enter_and_wait();
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out" / "ring.png"));
}

}  // namespace
}  // namespace foldless::test
