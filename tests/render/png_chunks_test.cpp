// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/png_chunks.h"

#include <gtest/gtest.h>

namespace foldless {
namespace {

using namespace std::string_literals;

TEST(PngChunks, EndChunkIsThatOfTheStandard) {
  EXPECT_EQ(png_chunk({"IEND", ""}), "\0\0\0\0IEND\xAE\x42\x60\x82"s);
}

TEST(PngChunks, ComeBackOneByOne) {
  const std::string file = png_chunk({"aaAa", "first"}) + png_chunk({"bbBb", ""});
  std::size_t offset = 0;
  const auto first = next_png_chunk(file, offset);
  const auto second = next_png_chunk(file, offset);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->type, "aaAa");
  EXPECT_EQ(first->data, "first");
  EXPECT_EQ(second->type, "bbBb");
  EXPECT_EQ(offset, file.size());
  EXPECT_FALSE(next_png_chunk(file, offset));
}

TEST(PngChunks, AChunkThatIsCutShortIsNone) {
  const std::string whole = png_chunk({"aaAa", "data"});
  for (std::size_t kept = 0; kept < whole.size(); ++kept) {
    std::size_t offset = 0;
    EXPECT_FALSE(next_png_chunk(std::string_view(whole).substr(0, kept), offset)) << kept;
  }
}

TEST(Crc32, IsTheOneOfTheStandardWhateverThePieces) {
  const std::string check = "123456789";
  EXPECT_EQ(crc32_of(check), 0xCBF43926U);
  EXPECT_EQ(crc32_of(std::string(32, '\xFF')), 0xFF6CAB0BU);
  for (std::size_t cut = 0; cut <= check.size(); ++cut) {
    Crc32 crc;
    crc.add(check.substr(0, cut));
    crc.add(check.substr(cut));
    EXPECT_EQ(crc.value(), 0xCBF43926U) << "cut after " << cut << " bytes";
  }
}

}  // namespace
}  // namespace foldless
