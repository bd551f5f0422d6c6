// SPDX-License-Identifier: GPL-3.0-or-later
// JPEG files of four inks, as Photoshop and other programs for print write them.
#include <gtest/gtest.h>

#include <cstdio>
#include <vector>

// After cstdio, which it needs.
#include <jpeglib.h>

#include <array>
#include <cstdlib>

#include "render/image.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

using Inks = std::array<unsigned char, 4>;

/// Inks as the file has them: 255 is none.
std::string jpeg_of(const Inks& inks, J_COLOR_SPACE stored, bool has_adobe_marker) {
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &bytes, &size);
  jpeg.image_width = jpeg.image_height = 16;
  jpeg.input_components = 4;
  jpeg.in_color_space = JCS_CMYK;
  jpeg_set_defaults(&jpeg);
  jpeg_set_colorspace(&jpeg, stored);
  jpeg_set_quality(&jpeg, 100, TRUE);
  jpeg.write_Adobe_marker = has_adobe_marker ? TRUE : FALSE;
  jpeg_start_compress(&jpeg, TRUE);
  std::vector<unsigned char> row;
  for (int x = 0; x < 16; ++x) row.insert(row.end(), inks.begin(), inks.end());
  unsigned char* rows = row.data();
  for (int y = 0; y < 16; ++y) jpeg_write_scanlines(&jpeg, &rows, 1);
  jpeg_finish_compress(&jpeg);
  jpeg_destroy_compress(&jpeg);
  std::string file(reinterpret_cast<char*>(bytes), size);
  std::free(bytes);
  return file;
}

class JpegForPrint : public testing::TestWithParam<std::pair<J_COLOR_SPACE, bool>> {};

TEST_P(JpegForPrint, HasTheColoursOfItsInks) {
  const TemporaryFolder folder;
  const auto [stored, has_marker] = GetParam();
  const std::array<std::pair<Inks, std::array<int, 3>>, 4> cases{{
      {{255, 255, 255, 255}, {255, 255, 255}},  // paper
      {{255, 255, 255, 0}, {0, 0, 0}},          // black ink
      {{0, 255, 255, 255}, {0, 255, 255}},      // cyan
      {{250, 100, 0, 128}, {125, 50, 0}},
  }};
  for (const auto& [inks, colour] : cases) {
    const Image image = load_image(folder.write("print.jpg", jpeg_of(inks, stored, has_marker)));
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(image.at(8, 8)[c], colour[c], 2) << c;
    EXPECT_EQ(image.at(8, 8)[3], 255);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, JpegForPrint,
                         testing::Values(std::pair{JCS_CMYK, true}, std::pair{JCS_YCCK, true},
                                         std::pair{JCS_CMYK, false}));

}  // namespace
}  // namespace foldless::test
