// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/jpeg_scans.h"

#include <gtest/gtest.h>
#include <turbojpeg.h>

#include <string>
#include <vector>

#include "render/image.h"
#include "tests/support/errors.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

constexpr int kSide = 64;

std::string jpeg_of_square(int flags) {
  const std::vector<unsigned char> pixels(std::size_t{3} * kSide * kSide, 120);
  void* encoder = tjInitCompress();
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  tjCompress2(encoder, pixels.data(), kSide, 0, kSide, TJPF_RGB, &bytes, &size, TJSAMP_444, 90,
              flags);
  std::string file(reinterpret_cast<char*>(bytes), size);
  tjFree(bytes);
  tjDestroy(encoder);
  return file;
}

/// A progressive picture whose last scan is there `more` times more.
std::string with_scans(std::size_t more) {
  std::string file = jpeg_of_square(TJFLAG_PROGRESSIVE);
  const std::string scan = file.substr(file.rfind("\xFF\xDA"));
  const std::string end = scan.substr(scan.size() - 2);
  file.resize(file.size() - end.size());
  for (std::size_t i = 0; i < more; ++i) file += scan.substr(0, scan.size() - 2);
  return file + end;
}

TEST(JpegScans, AreCountedInPlainAndProgressiveFiles) {
  EXPECT_EQ(jpeg_scans(jpeg_of_square(0)), 1U);
  EXPECT_EQ(jpeg_scans(jpeg_of_square(TJFLAG_PROGRESSIVE)), 10U);
  EXPECT_EQ(jpeg_scans(with_scans(5)), 15U);
}

TEST(JpegScans, OfAPreviewInTheFileDoNotCount) {
  std::string file = jpeg_of_square(0);
  const std::string preview = jpeg_of_square(TJFLAG_PROGRESSIVE);
  const std::size_t length = preview.size() + 2;
  const std::string application{'\xFF', '\xE1', static_cast<char>(length >> 8),
                                static_cast<char>(length)};
  file.insert(2, application + preview);
  EXPECT_EQ(jpeg_scans(file), 1U);
}

TEST(JpegScans, AreCountedInWhatIsCutShort) {
  EXPECT_EQ(jpeg_scans("\xFF"), 0U);
  EXPECT_EQ(jpeg_scans("\xFF\xD8\xFF\xDA"), 1U);
  EXPECT_EQ(jpeg_scans("\xFF\xD8\xFF\xFF\xDA\xFF"), 1U);
}

TEST(JpegScans, AboveTheLimitAreRefusedWithTheirNumber) {
  const TemporaryFolder folder;
  const auto file = folder.write("a.jpg", with_scans(5000));
  EXPECT_EQ(error_of([&] { load_image(file); }),
            file.string() +
                ": the JPEG image has 5010 scans, more than the 100 that are read at its size; "
                "save it as one that is not progressive");
}

TEST(JpegScans, AreFewerInALargePicture) {
  EXPECT_EQ(error_of([] { check_jpeg_scans(with_scans(20), 100'000'000); }), "");
  EXPECT_NE(error_of([] { check_jpeg_scans(with_scans(21), 100'000'000); }), "");
}

TEST(JpegScans, OfAUsualProgressivePictureAreRead) {
  const TemporaryFolder folder;
  EXPECT_EQ(load_image(folder.write("a.jpg", jpeg_of_square(TJFLAG_PROGRESSIVE))).width, kSide);
}

}  // namespace
}  // namespace foldless::test
