// SPDX-License-Identifier: GPL-3.0-or-later
// What one format has and the others do not, and limits.
#include <gtest/gtest.h>

#include "render/layered/layered_image.h"
#include "tests/support/errors.h"
#include "tests/support/layered_files.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

class LayerFormats : public testing::Test {
 protected:
  LayeredImage read(const std::string& bytes) const {
    return load_layered(folder_.write("a", bytes));
  }
  std::string refusal(const std::string& bytes) const {
    return error_of([&] { read(bytes); });
  }
  /// An OpenRaster file of one picture and these elements.
  std::string ora(const std::string& elements) const {
    return zip_of({{"stack.xml", ora_xml(canvas_, elements)},
                   {"dot.png", encode_png(dot_)},
                   {"mergedimage.png", encode_png(plain(9, 9, {0, 0, 0, 0}))}});
  }
  /// A Krita file of a layer with this file and these attributes.
  std::string kra(const std::string& tiles, const std::string& attributes) const {
    return zip_of({{"maindoc.xml",
                    "<DOC><IMAGE name='N' width='9' height='9'><layers><layer "
                    "name='L' filename='l' " +
                        attributes + "/></layers></IMAGE></DOC>"},
                   {"N/layers/l", tiles},
                   {"mergedimage.png", encode_png(plain(9, 9, {7, 7, 7, 255}))}});
  }

  TemporaryFolder folder_;
  LayeredImage canvas_ = painting_of(9, 9, {});
  Image dot_ = plain(2, 2, {10, 20, 30, 255});
};

constexpr const char* kPaintLayer = "nodetype='paintlayer' colorspacename='RGBA'";

TEST_F(LayerFormats, OpenRasterStacksAddUp) {
  const LayeredImage read_back = read(
      ora("<stack name='G' x='2' y='1' opacity='0.5'>" +
          ora_layer(block("In", 3, 4, dot_), "dot.png") + "</stack><stack visibility='hidden'>" +
          ora_layer(block("Out", 0, 0, dot_), "dot.png") + "</stack>"));
  ASSERT_EQ(read_back.layers.size(), 2U);
  EXPECT_FALSE(read_back.layers[0].is_visible) << "hidden with its stack";
  EXPECT_EQ(read_back.layers[1].x, 5);
  EXPECT_EQ(read_back.layers[1].y, 5);
  EXPECT_EQ(read_back.layers[1].opacity, 0.5);
  ASSERT_EQ(read_back.notices.size(), 1U);
  EXPECT_EQ(read_back.notices[0], "groups whose opacity goes to each of their layers: G");
}

TEST_F(LayerFormats, TellOfBlendModes) {
  const std::string more = " composite-op='svg:multiply'";
  const LayeredImage read_back = read(ora(ora_layer(block("Shade", 0, 0, dot_), "dot.png", more)));
  ASSERT_EQ(read_back.notices.size(), 1U);
  EXPECT_NE(read_back.notices[0].find("blend mode: Shade"), std::string::npos);
}

TEST_F(LayerFormats, OpenRasterWithoutAMergedPictureIsComposed) {
  const LayeredImage one = painting_of(9, 9, {block("Dot", 3, 4, dot_)});
  const std::string bytes = zip_of({{"stack.xml", ora_xml(one, ora_layer(one.layers[0], "d.png"))},
                                    {"d.png", encode_png(dot_)}});
  EXPECT_EQ(load_image(folder_.write("a.ora", bytes)), one.merged);
}

TEST_F(LayerFormats, RefuseWhatIsTooLargeBeforeItIsUnpacked) {
  EXPECT_NE(refusal(zip_of({{"stack.xml", std::string(20 << 20, ' ')}})).find("more than 16 MiB"),
            std::string::npos);
  EXPECT_NE(refusal(zip_of({{"stack.xml", "<image w='20000' h='2'/>"}})).find("16384 a side"),
            std::string::npos);
  std::string psd = psd_of(painting_of(9, 9, {}));
  psd.replace(14, 4, big_endian(16000, 4)).replace(18, 4, big_endian(16000, 4));
  EXPECT_NE(refusal(psd).find("100000000 in all"), std::string::npos);
}

TEST_F(LayerFormats, RefuseFilesOfAnotherChecksum) {
  std::string bytes = zip_of({{"stack.xml", ora_xml(canvas_, "")}});
  bytes[bytes.find("PK\1\2") + 16] ^= 1;
  EXPECT_NE(refusal(bytes).find("stack.xml in the archive is damaged or locked"),
            std::string::npos);
}

TEST_F(LayerFormats, RefuseGroupsNestedTooDeeply) {
  std::string opening, closing;
  for (int i = 0; i < 5000; ++i) {
    opening += "<stack>";
    closing += "</stack>";
  }
  EXPECT_NE(refusal(ora(opening + closing)).find("nested more than 100 deep"), std::string::npos);
}

TEST_F(LayerFormats, WithTooManyLayersOrPixelsAreReadMerged) {
  std::string layers;
  for (int i = 0; i < 1001; ++i) layers += ora_layer({"L", 0, 0, {}, 1, false}, "dot.png");
  const LayeredImage many = read(ora(layers));
  EXPECT_TRUE(many.layers.empty());
  EXPECT_EQ(many.merged.width, 9);
  EXPECT_EQ(many.notices, std::vector<std::string>{
                              "The file has more than 1000 layers: they are only read merged"});
  const Image large = plain(3000, 3000, {1, 2, 3, 255});
  layers.clear();
  for (int i = 0; i < 12; ++i) layers += ora_layer(block("L", 0, 0, large), "large.png");
  std::vector<std::pair<std::string, std::string>> files{
      {"stack.xml", ora_xml(painting_of(3000, 3000, {}), layers)},
      {"large.png", encode_png(large)}};
  EXPECT_NE(refusal(zip_of(files)).find("no merged picture"), std::string::npos);
  files.emplace_back("mergedimage.png", files.back().second);
  const LayeredImage heavy = read(zip_of(files));
  EXPECT_TRUE(heavy.layers.empty());
  ASSERT_EQ(heavy.notices.size(), 1U);
  EXPECT_NE(heavy.notices[0].find("100000000 pixels in all"), std::string::npos);
}

TEST_F(LayerFormats, RefuseWrongWordsInTheirXml) {
  EXPECT_NE(refusal(ora("<layer name='L' src='dot.png' x='east'/>")).find("not a number: 'east'"),
            std::string::npos);
  EXPECT_NE(refusal(ora("<layer name='L' src='dot.png' x='2000000000'/>")).find("too far"),
            std::string::npos);
  EXPECT_NE(
      refusal(ora("<layer name='L' src='no.png'/>")).find("the layer 'L': there is no no.png"),
      std::string::npos);
  EXPECT_NE(refusal(ora("<layer name='L'")).find("stack.xml in the archive is damaged"),
            std::string::npos);
  EXPECT_NE(refusal(zip_of({{"a.txt", "?"}})).find("not of OpenRaster or Krita"),
            std::string::npos);
}

TEST_F(LayerFormats, KritaTilesOffTheCanvasAreDropped) {
  std::string tiles = kra_tiles(block("L", 0, 0, plain(64, 64, {50, 60, 70, 255})));
  tiles.replace(tiles.find("0,0,LZF"), 7, "-60,-61,LZF");
  const LayeredImage read_back = read(kra(tiles, std::string(kPaintLayer) + " x='2'"));
  ASSERT_EQ(read_back.layers.size(), 1U);
  EXPECT_EQ(read_back.layers[0].image, plain(6, 3, {50, 60, 70, 255}));
  EXPECT_EQ(read_back.layers[0].x, 0);
}

TEST_F(LayerFormats, KritaFillsWithTheDefaultPixel) {
  const std::string none = "VERSION 2\nTILEWIDTH 64\nTILEHEIGHT 64\nPIXELSIZE 4\nDATA 0\n";
  std::string bytes = zip_of(
      {{"maindoc.xml", std::string("<DOC><IMAGE name='N' width='9' height='9'><layers><layer "
                                   "name='L' filename='l' ") +
                           kPaintLayer + "/></layers></IMAGE></DOC>"},
       {"N/layers/l", none},
       {"N/layers/l.defaultpixel", "\3\2\1\xFF"}});
  EXPECT_EQ(load_image(folder_.write("a.kra", bytes)), plain(9, 9, {1, 2, 3, 255}));
}

TEST_F(LayerFormats, KritaOfOtherColoursIsReadMerged) {
  const LayeredImage read_back = read(kra("", "nodetype='paintlayer' colorspacename='RGBAF16'"));
  EXPECT_TRUE(read_back.layers.empty());
  EXPECT_EQ(read_back.merged, plain(9, 9, {7, 7, 7, 255}));
  ASSERT_EQ(read_back.notices.size(), 1U);
  EXPECT_NE(read_back.notices[0].find("only read merged"), std::string::npos);
}

TEST_F(LayerFormats, KritaOfOtherColoursWithoutAMergedPictureSaysWhy) {
  const std::string bytes =
      zip_of({{"maindoc.xml",
               "<DOC><IMAGE name='N' width='9' height='9'><layers><layer name='L' "
               "nodetype='paintlayer' colorspacename='RGBAF32'/></layers></IMAGE></DOC>"}});
  EXPECT_NE(refusal(bytes).find("8-bit RGB colours are only read merged: the layer 'L'"),
            std::string::npos);
}

TEST_F(LayerFormats, KritaTellsOfLayersThatAreNotPainted) {
  const LayeredImage read_back = read(kra("", "nodetype='shapelayer' colorspacename='RGBA'"));
  ASSERT_EQ(read_back.notices.size(), 1U);
  EXPECT_EQ(read_back.notices[0], "left out, as they are no paint layers: L");
}

TEST_F(LayerFormats, PhotoshopGroupsHoldWhatIsBelowThem) {
  const LayeredImage canvas = painting_of(9, 9, {});
  PictureLayer end{"</end>", 0, 0, {}, 1, true}, group{"Group", 0, 0, {}, 0.5, true};
  PictureLayer hidden = group;
  hidden.is_visible = false;
  const LayeredImage read_back = read(psd_of(canvas,
                                             {{block("Below", 0, 0, dot_)},
                                              {end, "norm", 3},
                                              {block("In", 1, 0, dot_)},
                                              {group, "pass", 1},
                                              {end, "norm", 3},
                                              {block("Out", 2, 0, dot_)},
                                              {hidden, "pass", 1},
                                              {block("Above", 3, 0, dot_), "mul ", -1, "mask"}},
                                             PsdPacking::bits));
  ASSERT_EQ(read_back.layers.size(), 4U);
  EXPECT_EQ(read_back.layers[0].name, "Below");
  EXPECT_EQ(read_back.layers[0].opacity, 1);
  EXPECT_NEAR(read_back.layers[1].opacity, 128 / 255.0, 1e-9);
  EXPECT_FALSE(read_back.layers[2].is_visible);
  EXPECT_TRUE(read_back.layers[3].is_visible);
  EXPECT_EQ(read_back.layers[3].name, "Above");
  EXPECT_EQ(read_back.notices.size(), 3U) << "opacity of a group, blend mode, mask";
}

TEST_F(LayerFormats, PhotoshopWithWhatLayersLackIsTheMergedPictureOffItsWhite) {
  LayeredImage painting = painting_of(9, 9, {block("L", 0, 0, plain(9, 9, {200, 100, 0, 80}))});
  painting.merged = plain(9, 9, {10, 60, 120, 102});
  const LayeredImage read_back =
      read(psd_of(painting, {{painting.layers[0], "mul "}}, PsdPacking::bits));
  EXPECT_EQ(read_back.layers.size(), 1U);
  for (int c = 0; c < 4; ++c)
    EXPECT_NEAR(read_back.merged.at(4, 4)[c], painting.merged.at(4, 4)[c], 3) << c;
}

TEST_F(LayerFormats, PhotoshopOfOtherColoursIsReadMerged) {
  LayeredImage painting = painting_of(9, 9, {block("L", 0, 0, plain(9, 9, {200, 100, 0, 255}))});
  painting.layers.clear();
  std::string psd = psd_of(painting, PsdPacking::none);
  psd.replace(24, 2, big_endian(1, 2));  // grey
  const LayeredImage read_back = read(psd);
  EXPECT_TRUE(read_back.layers.empty());
  EXPECT_EQ(read_back.notices.size(), 1U);
  EXPECT_EQ(read_back.merged.at(4, 4)[0], 200);
  EXPECT_EQ(read_back.merged.at(4, 4)[2], 200);
  psd.replace(24, 2, big_endian(9, 2));  // L*a*b*
  EXPECT_NE(refusal(psd).find("RGB, CMYK or grey"), std::string::npos);
  psd.replace(4, 2, big_endian(2, 2));
  EXPECT_NE(refusal(psd).find(".psb"), std::string::npos);
}

}  // namespace
}  // namespace foldless::test
