// SPDX-License-Identifier: GPL-3.0-or-later
// What small files may ask for.
#include <gtest/gtest.h>

#include "render/image.h"
#include "tests/app/cli/command.h"
#include "tests/core/run/scripted_method.h"
#include "tests/support/sanitizers.h"

namespace foldless {
namespace {

using test::Ended;
using test::TemporaryFolder;
using test::write_text;

/// The peak of drawing a file, or a small scene with a picture [MiB].
Ended draw(const TemporaryFolder& folder, const std::string& file,
           const std::string& texture = "") {
  std::vector<std::string> arguments{"render", file, "-o", folder / "out.png", "--size", "64x48"};
  if (!texture.empty()) arguments.insert(arguments.end(), {"--texture", texture});
  return test::run(arguments);
}

TEST(Memory, HeadersThatPromiseMuchAreRefusedWithoutIt) {
  if (test::kIsSanitized) GTEST_SKIP() << "sanitizers take memory of their own";
  const TemporaryFolder folder;
  const std::string counts = "1000000000";
  write_text(folder / "a.off", "OFF\n" + counts + ' ' + counts + " 0\n0 0 0\n");
  const std::string elements = "element vertex " + counts +
                               "\nproperty float x\nproperty float y\nproperty float z\n"
                               "element face " +
                               counts + "\nproperty list uchar int vertex_indices\nend_header\n";
  write_text(folder / "a.ply", "ply\nformat ascii 1.0\n" + elements + "0 0 0\n");
  write_text(folder / "b.ply", "ply\nformat binary_little_endian 1.0\n" + elements + "0 0 0\n");
  for (const std::string name : {"a.off", "a.ply", "b.ply"}) {
    const Ended ended = draw(folder, folder / name);
    EXPECT_EQ(ended.status, 2);
    EXPECT_NE(ended.err.find(counts), std::string::npos) << ended.err;
    EXPECT_LT(ended.peak, 500) << name;
  }
}

TEST(Memory, AChunkThatPromisesMuchIsRefusedWithoutIt) {
  if (test::kIsSanitized) GTEST_SKIP() << "sanitizers take memory of their own";
  const TemporaryFolder folder;
  const std::string scene = folder / "scene.json";
  test::write_scene(scene, test::grid_problem(3, Vec2(2, 2)));
  constexpr std::size_t kHeaderEnd = 33;
  const std::string header = encode_png(Image(4, 4)).substr(0, kHeaderEnd);
  write_text(folder / "a.png", header + "\x7F\xFF\xFF\xFFzTXtabc");
  const Ended ended = draw(folder, scene, folder / "a.png");
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE(ended.err.find("a.png: the PNG image is damaged"), std::string::npos) << ended.err;
  EXPECT_LT(ended.peak, 500);
}

TEST(Memory, APictureTakesAtMostThriceItsDecodedSize) {
  if (test::kIsSanitized) GTEST_SKIP() << "sanitizers take memory of their own";
  const TemporaryFolder folder;
  const std::string scene = folder / "scene.json";
  test::write_scene(scene, test::grid_problem(3, Vec2(2, 2)));
  constexpr int kSide = 4096;  // 64 MiB
  {
    const Image image(kSide, kSide);
    save_png(folder / "large.png", image);
  }
  const double without = draw(folder, scene).peak;
  const Ended with = draw(folder, scene, folder / "large.png");
  EXPECT_EQ(with.status, 0) << with.err;
  EXPECT_LT(with.peak - without, 3 * 64);
  EXPECT_GT(with.peak - without, 64) << "is it measured at all?";
}

}  // namespace
}  // namespace foldless
