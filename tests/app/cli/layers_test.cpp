// SPDX-License-Identifier: GPL-3.0-or-later
// Paintings of several layers: meshed layer by layer, and drawn.
#include <gtest/gtest.h>

#include "app/cli/problem.h"
#include "core/files/atomic_file.h"
#include "tests/app/cli/command.h"
#include "tests/support/layered_files.h"
#include "tests/support/pixels.h"

namespace foldless::test {
namespace {

/// How many pixels of a drawing with a border are not those of the painting.
int wrong_pixels(const Image& drawn, const Image& painting, int border) {
  int wrong = 0;
  for (int y = 0; y < painting.height; ++y)
    for (int x = 0; x < painting.width; ++x) {
      const std::uint8_t *pixel = drawn.at(x + border, y + border), *original = painting.at(x, y);
      // Colours of what is hardly seen were rounded.
      const bool is_seen = original[3] > 30;
      if (std::abs(pixel[3] - original[3]) > 1 || (is_seen && difference(pixel, original) > 4))
        ++wrong;
      if (original[3] == 255 && difference(pixel, original) > 1) ++wrong;
    }
  return wrong;
}

class MeshByLayer : public testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& bytes) const {
    write_file_atomically(folder_ / name, bytes);
    return folder_ / name;
  }
  Ended mesh(const std::string& file) const {
    return run({"mesh", file, "-o", folder_ / "doll.json", "--layers"});
  }
  /// One pixel a pixel of the painting, whose corner is 10 pixels from that of the picture.
  Image rendered(std::string* notes = nullptr) const {
    const Ended ended =
        run({"render", folder_ / "doll.json", "-o", folder_ / "out.png", "--size", "180x220",
             "--layers", "fill", "--transparent", "--camera", "80,100,1"});
    EXPECT_EQ(ended.status, 0) << ended.err;
    if (notes) *notes = ended.err;
    return load_image(folder_ / "out.png");
  }

  TemporaryFolder folder_;
};

TEST_F(MeshByLayer, TheUndeformedSceneIsThePaintingToWithinOneGreyLevel) {
  const LayeredImage painting = doll();
  for (const auto& [name, bytes] :
       {std::pair{"doll.ora", ora_of(painting)}, std::pair{"doll.kra", kra_of(painting)},
        std::pair{"doll.psd", psd_of(painting)}}) {
    const Ended ended = mesh(write(name, bytes));
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_NE(ended.out.find(" 4 parts, 0 holes"), std::string::npos) << ended.out;
    EXPECT_EQ(wrong_pixels(rendered(), painting.merged, 10), 0) << name;
    const Scene scene = load_scene_file(folder_ / "doll.json").scene;
    ASSERT_NE(scene.parts, nullptr);
    ASSERT_EQ(scene.parts->size(), 4U);
    EXPECT_EQ(scene.parts->at(3).layer, "Right arm");
    EXPECT_GT(scene.parts->at(3).depth, scene.parts->at(2).depth);
  }
}

TEST_F(MeshByLayer, WithoutTheOptionThereAreNoParts) {
  const std::string file = write("doll.ora", ora_of(doll()));
  ASSERT_EQ(run({"mesh", file, "-o", folder_ / "doll.json"}).status, 0);
  EXPECT_EQ(load_scene_file(folder_ / "doll.json").scene.parts, nullptr);
  // The half transparent head is opaque enough here too.
  EXPECT_EQ(wrong_pixels(rendered(), doll().merged, 10), 0);
}

TEST_F(MeshByLayer, AChangedFileIsFoundLayerByLayer) {
  LayeredImage painting = doll();
  ASSERT_EQ(mesh(write("doll.ora", ora_of(painting))).status, 0);
  // Another order, other names before it, a colour: what is found is found by name.
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 160; ++x) painting.layers[3].image.at(x, y)[0] = 255;
  std::swap(painting.layers[0], painting.layers[2]);
  painting.layers.insert(painting.layers.begin(),
                         block("New", 0, 0, plain(160, 200, {0, 0, 0, 255})));
  write("doll.ora", ora_of(painting));
  std::string notes;
  const Image drawn = rendered(&notes);
  EXPECT_EQ(notes, "");
  EXPECT_EQ(drawn.at(10 + 140, 10 + 90)[0], 255);
  EXPECT_EQ(drawn.at(10 + 80, 10 + 150)[0], 240) << "the body";
  EXPECT_EQ(drawn.at(10 + 2, 10 + 2)[3], 0);
}

TEST_F(MeshByLayer, ALayerThatIsGoneIsANoteAndAHiddenOneIsNotSeen) {
  LayeredImage painting = doll();
  ASSERT_EQ(mesh(write("doll.ora", ora_of(painting))).status, 0);
  painting.layers[1].is_visible = false;
  painting.layers.pop_back();
  write("doll.ora", ora_of(painting));
  std::string notes;
  const Image drawn = rendered(&notes);
  EXPECT_EQ(notes,
            "foldless: note: doll.ora has no layer 'Right arm' any more: its part is not seen\n");
  EXPECT_EQ(drawn.at(10 + 80, 10 + 30)[3], 0) << "the head";
  EXPECT_EQ(drawn.at(10 + 140, 10 + 90)[3], 0) << "the right arm";
  EXPECT_EQ(drawn.at(10 + 100, 10 + 90)[3], 255) << "the body under it";
}

TEST_F(MeshByLayer, RefusesWhatHasNoLayersInOneLine) {
  const std::string picture = write("a.png", encode_png(doll().merged));
  const std::string clear =
      write("a.ora", ora_of(painting_of(9, 9, {block("A", 0, 0, plain(9, 9, {1, 1, 1, 5}))})));
  const std::string none = write("none.ora", ora_of(painting_of(9, 9, {})));
  for (const auto& [file, words] :
       {std::pair{picture, "is not an OpenRaster, Krita or Photoshop file"},
        std::pair{clear, "the layers are transparent everywhere"},
        std::pair{none, "leave out --layers"}}) {
    const Ended ended = mesh(file);
    EXPECT_EQ(ended.status, 2);
    EXPECT_NE(ended.err.find(words), std::string::npos) << ended.err;
    EXPECT_EQ(std::ranges::count(ended.err, '\n'), 1) << ended.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "doll.json"));
  }
}

}  // namespace
}  // namespace foldless::test
