// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/baked_io.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/files/atomic_file.h"
#include "tests/support/errors.h"
#include "tests/support/meshes.h"
#include "tests/support/temporary_folder.h"

namespace foldless {
namespace {

BakedAnimation three_frames() {
  const test::Fixture f = test::square_grid(3);
  BakedAnimation animation;
  animation.triangles = f.triangles;
  animation.rest = f.rest / 3.0;
  animation.original_vertices = 9;
  animation.loops = true;
  animation.cycle_frames = 4;
  animation.fps = 23.976;
  animation.deviation = 0.1 + 0.2;
  for (const double frame : {0.0, 1.0 / 3, 2.0}) {
    Points bent = animation.rest;
    bent.row(0) += (0.1 * frame * animation.rest.row(1).array().sin()).matrix();
    animation.frames.push_back({frame, bent});
  }
  return animation;
}

class BakedIo : public testing::Test {
 protected:
  std::string error_of(const std::string& text) const {
    write_file_atomically(file(), text);
    return test::error_of([&] { read_baked(file()); });
  }
  /// What is wrong after a part of a good file was replaced.
  std::string error_with(const std::string& old, const std::string& now) const {
    std::string text = baked_text(three_frames(), {});
    const std::size_t at = text.find(old);
    EXPECT_NE(at, text.npos) << old;
    std::string error = error_of(text.replace(at, old.size(), now));
    const std::size_t name = error.find("walk.foldless");
    return name == error.npos ? error : error.substr(name);
  }
  std::filesystem::path file() const { return folder_ / "walk.foldless"; }

  test::TemporaryFolder folder_;
};

TEST_F(BakedIo, IsReadAsItWasWrittenToTheLastBit) {
  const BakedAnimation written = three_frames();
  write_file_atomically(file(), baked_text(written, {}));
  const BakedAnimation read = read_baked(file());
  EXPECT_EQ(read.triangles, written.triangles);
  EXPECT_EQ(read.rest, written.rest);
  EXPECT_EQ(read.original_vertices, 9);
  EXPECT_TRUE(read.loops);
  EXPECT_EQ(read.cycle_frames, 4);
  EXPECT_EQ(read.fps, 23.976);
  EXPECT_EQ(read.deviation, written.deviation);
  ASSERT_EQ(read.frames.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(read.frames[i].frame, written.frames[i].frame);
    EXPECT_EQ(read.frames[i].deformed, written.frames[i].deformed);
  }
  EXPECT_TRUE(failures_of(read).empty());
}

TEST_F(BakedIo, SaysWhatIsNotProved) {
  BakedAnimation animation = three_frames();
  animation.frames[1].deformed *= -1;
  const std::vector<BakedFailure> failures = failures_of(animation);
  ASSERT_EQ(failures.size(), 2U);
  const std::string text = baked_text(animation, failures);
  EXPECT_NE(text.find("\"proved\":false"), text.npos);
  EXPECT_NE(text.find("\"failures\":[{\"after\":0,\"share\":0.49999"), text.npos)
      << text.substr(0, 400);
  write_file_atomically(file(), text);
  EXPECT_EQ(failures_of(read_baked(file())).size(), 2U);
}

TEST_F(BakedIo, RefusesWhatCannotBePlayed) {
  EXPECT_EQ(error_with("\"version\":1", "\"version\":2"),
            "walk.foldless:1: version is 2, but this program reads version 1");
  EXPECT_EQ(error_with("\"foldless\":\"animation\"", "\"foldless\":\"film\""),
            "walk.foldless:1: foldless is 'film', but 'animation' is needed");
  EXPECT_EQ(error_with("\"frames\":3", "\"frames\":2"),
            "walk.foldless:4: there is more than the 2 frames that the first line counts");
  EXPECT_EQ(error_with("\"frames\":3", "\"frames\":4"), "walk.foldless: ends before frame 3");
  EXPECT_EQ(error_with("{\"frame\":2", "{\"frame\":0.1"),
            "walk.foldless:4: frame is 0.1, but must be after the frame before");
  EXPECT_EQ(error_with("{\"frame\":2,\"deformed\":[[0,0],", "{\"frame\":2,\"deformed\":["),
            "walk.foldless:4: deformed has 8 vertices, but 'rest' has 9");
  EXPECT_EQ(error_with("{\"frame\":2,", "{\"frame\":2,\"name\":\"a\","),
            "walk.foldless:4: 'name' = 'a' is an unknown key; known keys are frame, deformed");
  EXPECT_NE(error_with("\"triangles\":[[0,", "\"triangles\":[[1,"), "no error");
  EXPECT_NE(error_of("").find("walk.foldless: ends before the mesh"), std::string::npos);
  EXPECT_NE(error_of("{").find("walk.foldless:1: "), std::string::npos);
}

}  // namespace
}  // namespace foldless
